// Brings project, recording and result into the 3D view: which body, which film, at which moment.
#pragma once

#include "search/CoveragePreview.h"
#include "workbench/appearance/ArtworkPainter.h"
#include "workbench/appearance/BodyPrintPreview.h"
#include "workbench/appearance/MarkLines.h"
#include "workbench/appearance/ViewLooks.h"
#include "workbench/dip/DipJob.h"
#include "workbench/project/PrintFields.h"
#include "workbench/widgets/HeatScale.h"

#include <QObject>
#include <variant>

namespace dipwright {

class DipScene : public QObject {
    Q_OBJECT

public:
    explicit DipScene(DipView& view, QObject* parent = nullptr);

    // The job as it is set up: body in its pose above the flat film. Does what has changed.
    void setProject(const Project& project, std::size_t immersion);
    // How the dip went; null: not yet.
    void setResult(std::shared_ptr<const JobResult> result,
                   std::shared_ptr<const FilmReadout> reading);

    // The moments: before the dip as set up now, in the middle, at the end with the whole film.
    void showSetup();
    void showFrame(const std::shared_ptr<const DipRecording>& recording,
                   const RecordedFrame& frame);
    void showEnd();
    // The room in the world that the body takes on its way down.
    const BoundingBox& bodyRoom() const { return bodyRoom_; }
    double depth() const { return descent_ - startHeight; } // mm under water, of what is shown

    void setFilmLook(FilmLook look, const QImage& picture = {});
    void setFilmExtent(FilmExtent extent);
    void setHeat(FilmQuantity quantity, const HeatScale& scale);
    void setBodyLook(BodyLook look);
    void setShownPrint(const ShownPrint& print); // of BodyLook::Print
    // The last film of `result` dipped deeper, for prints that show it so.
    void setDeeperFilm(const std::shared_ptr<const JobResult>& result,
                       std::shared_ptr<const LaidFilm> film);
    // Whether the user's marks for the join are drawn whatever the body wears; over the coverage
    // they always are.
    void setMarking(bool marking);
    // What is told in BodyLook::Zones; null: nothing that is true of the project.
    void setTolerances(std::shared_ptr<const JobTolerances> tolerances);
    void setShowHandles(bool show);
    // Round the layer of the artwork that is worked on, model coordinates; empty: none.
    void setFrame(std::vector<ViewLine> frame);
    // While the body is being turned it wears what its pose would paint, by its shape.
    void setPreviewed(bool previewed);

    // From the world to the pose frame at the end of the dip; only while the end is shown.
    std::optional<Eigen::Isometry3d> worldToEnd() const;
    std::shared_ptr<const TexturedMesh> model() const { return project_.model; } // null: none
    // The shown model's place that `ray` meets first, in model coordinates.
    std::optional<Eigen::Vector3f> modelPoint(const ViewRay& ray) const;
    std::optional<SurfacePoint> modelSurface(const ViewRay& ray) const;
    Eigen::Vector3f toWorld(const Eigen::Vector3f& modelPoint) const;
    Eigen::Vector3f toModel(const Eigen::Vector3f& worldPoint) const;
    // Of the model that is shown; there must be one.
    SurfacePoint nearestSurface(const Eigen::Vector3f& modelPoint) const;

signals:
    void bodyRoomChanged();
    // A print is to be shown that needs the last film of the result dipped deeper.
    void deeperFilmWanted(const std::shared_ptr<const dipwright::JobResult>& result);

private:
    enum class Moment { Setup, Frame, End };
    // What the view's film has been made for: the project's film, lying flat; one on its way; one
    // that was dipped. None: it is to be made anew.
    enum class FlatFilm { OfProject };
    using FilmSource = std::variant<std::monostate, FlatFilm, std::shared_ptr<const DipRecording>,
                                    std::shared_ptr<const FilmReadout>>;

    void placeBody(const Immersion& immersion, double descent);
    void setBodyRoom(const Eigen::Isometry3d& modelToSetup);
    void setShape(const solver::FilmGrid& grid, const ThinnedFilm& film,
                  const std::vector<float>& positions);
    void updateFilm();
    void updateBody();
    void paintArtwork();
    void print();
    void slip(FilmAppearance& film); // as the shown print has it
    void showBody(BodyAppearance appearance);
    void showZones();
    void showPreview();
    void showLines();
    void showEndAnew(); // where the end is shown
    // At the end: by the extent, and none over the body whose coverage is shown.
    std::vector<FilmTriangle> shownTriangles(const LaidFilm& laid) const;
    std::vector<QRgb> frameColours() const;

    DipView& view_;
    Project project_;
    std::size_t immersion_ = 0;
    BodyAppearance shown_;                    // what the view shows as the body
    std::shared_ptr<const TexturedMesh> own_; // the project's model with its artwork, as painted
    ArtworkPainter artist_;
    std::vector<ViewLine> frame_;
    BodyPrintPreview printer_;
    std::shared_ptr<const BodyShare> shared_; // what `sharedBody_` was made for
    std::shared_ptr<const TexturedMesh> sharedBody_;
    std::unique_ptr<ZonedBody> zones_; // of the project's model; null until it is shown
    std::shared_ptr<const TexturedMesh> zonedBody_;
    std::unique_ptr<CoveragePreview> preview_; // of the project's model; null until it is shown
    std::shared_ptr<const TexturedMesh> previewedBody_;
    std::shared_ptr<const JobTolerances> tolerances_; // null: none that is true
    std::optional<MarkLines> marks_; // of the project's model; empty until there is a mark
    std::shared_ptr<const JobResult> result_;
    std::shared_ptr<const FilmReadout> reading_;
    std::shared_ptr<const LaidFilm> deeper_; // its last film dipped deeper; null: not yet
    // Whether that has not been asked for since the result, the look or the print that needs it is
    // another: a dip that was cancelled is not begun again for a view that is drawn anew.
    bool asksForDeeper_ = true;
    std::unique_ptr<SurfaceQuery> query_; // of the model
    Moment moment_ = Moment::Setup;
    Eigen::Isometry3d modelToWorld_ = Eigen::Isometry3d::Identity();
    double descent_ = 0;
    BoundingBox bodyRoom_;
    FilmSource filmSource_;
    ThinnedFilm shape_;
    solver::FilmGrid shapeGrid_;
    std::vector<float> positions_;
    FilmLook look_ = FilmLook::Lines;
    FilmExtent extent_ = FilmExtent::Whole;
    QImage picture_;
    FilmQuantity quantity_ = FilmQuantity::Length;
    HeatScale scale_;
    BodyLook bodyLook_ = BodyLook::Own;
    ShownPrint shownPrint_;
    bool marking_ = false;
    bool handles_ = true;
    bool previewed_ = false;
};

} // namespace dipwright

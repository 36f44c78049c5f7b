// Shows project, recording and result in the 3D view, at a chosen moment.
#pragma once

#include "cradle/Cradle.h"
#include "dip/BodyPath.h"
#include "marks/SurfaceMask.h"
#include "parallel/Tasks.h"
#include "search/CoveragePreview.h"
#include "workbench/appearance/ArtworkPainter.h"
#include "workbench/appearance/FinishedPartPreview.h"
#include "workbench/appearance/MarkLines.h"
#include "workbench/appearance/ViewLooks.h"
#include "workbench/dip/DipJob.h"
#include "workbench/document/PoseEdits.h"
#include "workbench/project/PrintFields.h"
#include "workbench/widgets/HeatScale.h"

#include <QObject>
#include <optional>
#include <variant>

namespace dipwright {

class DipScene : public QObject {
    Q_OBJECT

public:
    explicit DipScene(DipView& view, QObject* parent = nullptr);

    // Shows the job before the dip: the body in its pose above the flat film. Updates only what has
    // changed.
    void setProject(const Project& project, std::size_t immersion);
    // The result of the dip; null: none yet.
    void setResult(std::shared_ptr<const JobResult> result,
                   std::shared_ptr<const FilmReadout> reading);

    // Shows the body before the dip, with the current settings. The film of the result lies on the
    // body if setShowsDipped() and setWearsFilm() allow it; otherwise the flat film is drawn.
    void showSetup();
    // Shows a moment during the dip.
    void showFrame(const std::shared_ptr<const DipRecording>& recording,
                   const RecordedFrame& frame);
    void showEnd(); // the end of the dip, with the whole film
    // The world space through which the body moves during the dip.
    const BoundingBox& bodyRoom() const { return bodyRoom_; }
    // Depth of the body's lowest point below the water at the shown moment, mm.
    double depth() const { return depthAt(descent_); }
    // Returns the depth of the part's lowest point after it has descended, or has travelled along
    // its path, by `travelled` mm.
    double depthAt(double travelled) const;
    // Returns how far the part of the result has travelled when it takes each pose of its path, mm;
    // empty if the path does not go through poses.
    std::vector<double> travelledAtPoses() const;

    void setFilmLook(FilmLook look, const QImage& picture = {});
    void setFilmExtent(FilmExtent extent);
    void setHeat(FilmQuantity quantity, const HeatScale& scale);
    void setBodyLook(BodyLook look);
    void setShownPrint(const ShownPrint& print); // for BodyLook::Print
    // The last film of `result`, dipped deeper, for prints that show extra depth.
    void setDeeperFilm(const std::shared_ptr<const JobResult>& result,
                       std::shared_ptr<const LaidFilm> film);
    // Whether the user's marks for the seam are drawn with every body look. Over the coverage they
    // are always drawn.
    void setMarking(bool marking);
    // The tolerances for BodyLook::Zones; null: none that match the project.
    void setTolerances(std::shared_ptr<const JobTolerances> tolerances);
    // For BodyLook::Difference; the model must be that of the project, or a finer mesh of it.
    void setDifference(BodyAppearance appearance);
    // While the path goes through poses: the pose in which the body is shown before the dip; −1:
    // the first moment of the dip.
    void setPathKey(int key);
    // The pose in which the body is shown before the dip, for PoseEdits.h.
    const ShownPose& shownPose() const { return shownPose_; }
    void setShowHandles(bool show);
    // While the user has a brush, there are no handles, which would catch its strokes.
    void setBrushed(bool brushed);
    // Whether the result may be drawn before the dip: it fits the project, or soon will.
    void setShowsDipped(bool shows);
    // Whether the user wants to see the film of the result on the body before the dip.
    void setWearsFilm(bool wears);
    // What the user's brush marks at the moment; empty: nothing.
    void setStroke(ViewPatch patch);
    // A frame around the selected artwork layer, in model coordinates; empty: none.
    void setFrame(std::vector<ViewLine> frame);
    // Pins on the body of the result; places and directions in model coordinates. A pin is shown
    // with its dip; without one, with every dip.
    struct Pin {
        std::optional<std::size_t> dip;
        ViewPin pin;
    };
    void setPins(std::vector<Pin> pins);
    void setShowPins(bool show);
    // The cradles of the result, one for each dip; null: none are shown.
    void setCradles(std::shared_ptr<const std::vector<Cradle>> cradles);
    // While the user turns the body, it shows an estimate of the coverage from its shape.
    void setPreviewed(bool previewed);

    // Returns the transform from the world to the pose frame of the dipped film; nullopt unless
    // that film is drawn.
    std::optional<Eigen::Isometry3d> worldToEnd() const;
    std::shared_ptr<const TexturedMesh> model() const { return project_.model; } // null: none
    // The first place of the shown model that `ray` meets, in model coordinates.
    std::optional<Eigen::Vector3f> modelPoint(const ViewRay& ray) const;
    std::optional<SurfacePoint> modelSurface(const ViewRay& ray) const;
    // For queries of the shown model; null without a model. Waits while it is being built.
    const SurfaceQuery* query() const;
    // Points the camera at a place on the shown model, in model coordinates, and marks it.
    void lookAt(const Eigen::Vector3f& modelPoint);
    Eigen::Vector3f toWorld(const Eigen::Vector3f& modelPoint) const;
    Eigen::Vector3f toModel(const Eigen::Vector3f& worldPoint) const;
    // A model must be shown.
    SurfacePoint nearestSurface(const Eigen::Vector3f& modelPoint) const;

signals:
    void bodyRoomChanged();
    void pinClicked(std::size_t pin); // its number in setPins()
    // The shown print needs the last film of the result dipped deeper.
    void deeperFilmWanted(const std::shared_ptr<const dipwright::JobResult>& result);

private:
    enum class Moment { Setup, Frame, End };
    // The source of the film that is drawn: the flat film of the project, a recording, or a
    // finished dip. Empty: it must be built again.
    enum class FlatFilm { OfProject };
    struct Dipped {
        std::shared_ptr<const FilmReadout> reading;
        FilmExtent extent = FilmExtent::Whole;
        bool operator==(const Dipped&) const = default;
    };
    using FilmSource =
        std::variant<std::monostate, FlatFilm, std::shared_ptr<const DipRecording>, Dipped>;

    // `own`: the path of a result, without the offset; null: that of the project as it is.
    // `key`: the pose of the path that is shown before the dip.
    void placeBody(const Immersion& immersion, double descent,
                   const solver::BodyPath* own = nullptr,
                   std::optional<std::size_t> key = std::nullopt);
    // Returns the part's path without its offset. `pose` is poseTransform() of the immersion.
    const solver::BodyPath& pathOf(const Immersion& immersion, const Eigen::Isometry3d& pose);
    // Places the body as before the dip, or in the chosen pose of its path.
    void placeBeforeDip();
    void setBodyRoom(const Eigen::Isometry3d& modelToSetup);
    void setShape(const solver::FilmGrid& grid, const ThinnedFilm& film,
                  const std::vector<float>& positions);
    void updateFilm();
    void colourFilm();
    void updateBody();
    void paintArtwork();
    void print();
    Ground ground() const;           // of the part of the result
    bool isPrintDrawn() const;       // whether the film on the body shows what is printed
    void slip(FilmAppearance& film); // displaces the film as in the shown print
    void showBody(BodyAppearance appearance);
    void showZones();
    void showMasks();
    void showLegend();
    void showPreview();
    void showLines();
    void showPins();
    void showCradle();
    bool fitsResult() const;    // whether the result is of the shown model and dip
    bool isDippedDrawn() const; // whether the film of the result is drawn
    void drawDipped(FilmExtent extent);
    void showDippedAnew(); // draws the film of the result again if it is drawn
    // The triangles to draw of the dipped film. Empty over a body that shows its coverage.
    std::vector<FilmTriangle> shownTriangles(const DrapedFilm& film, FilmExtent extent) const;
    std::vector<QRgb> frameColours() const;

    DipView& view_;
    Project project_;
    std::size_t immersion_ = 0;
    BodyAppearance shown_;                    // the body as shown in the view
    std::shared_ptr<const TexturedMesh> own_; // the project's model with its painted artwork
    ArtworkPainter artworkPainter_;
    std::vector<ViewLine> frame_;
    std::vector<Pin> pins_;
    std::vector<std::size_t> shownPins_; // numbers in `pins_`
    bool showsPins_ = true;
    std::shared_ptr<const std::vector<Cradle>> cradles_;
    FinishedPartPreview printer_;
    std::shared_ptr<const BodyShare> shared_; // `sharedBody_` was built for it
    std::shared_ptr<const TexturedMesh> sharedBody_;
    std::unique_ptr<ZonedBody> zones_; // for the project's model; null until first shown
    std::shared_ptr<const TexturedMesh> zonedBody_;
    BodyAppearance difference_;                // for BodyLook::Difference
    std::shared_ptr<const SurfaceMask> mask_;  // of the project; null: nothing is masked
    std::unique_ptr<CoveragePreview> preview_; // for the project's model; null until first shown
    std::shared_ptr<const TexturedMesh> previewedBody_;
    std::shared_ptr<const JobTolerances> tolerances_; // null: none that match the project
    std::optional<MarkLines> marks_; // for the project's model; empty until there is a mark
    std::shared_ptr<const JobResult> result_;
    std::shared_ptr<const FilmReadout> reading_;
    std::shared_ptr<const LaidFilm> deeper_; // last dip's film, dipped deeper; null: not computed
    // Whether the deeper film may be requested. Reset when result, look or print change, so that
    // redrawing the view does not restart a cancelled dip.
    bool asksForDeeper_ = true;
    BoundingBox modelBox_;                // of the model
    std::unique_ptr<SurfaceQuery> query_; // for the model; query() waits for it
    mutable Tasks queryBuilding_;         // beside the UI thread: large models take a second
    Moment moment_ = Moment::Setup;
    Eigen::Isometry3d modelToWorld_ = Eigen::Isometry3d::Identity();
    double descent_ = 0;
    // The path that the part was placed on last, and poseTransform() of its dip.
    solver::BodyPath placedOn_;
    Eigen::Isometry3d placedPose_ = Eigen::Isometry3d::Identity();
    // The path that was computed last, and from what.
    solver::BodyPath path_;
    std::optional<Immersion> pathSource_;
    std::shared_ptr<const TexturedMesh> pathModel_;
    ProcessSettings pathProcess_;
    BoundingBox bodyRoom_;
    FilmSource filmSource_;
    ThinnedFilm shape_;
    solver::FilmGrid shapeGrid_;
    std::vector<float> positions_;
    FilmLook look_ = FilmLook::Sheet;
    FilmExtent extent_ = FilmExtent::Whole;
    QImage picture_;
    FilmQuantity quantity_ = FilmQuantity::Length;
    HeatScale scale_;
    BodyLook bodyLook_ = BodyLook::Own;
    ShownPrint shownPrint_;
    bool marking_ = false;
    int pathKey_ = -1;
    ShownPose shownPose_;
    bool handles_ = true, brushed_ = false;
    bool previewed_ = false;
    bool showsDipped_ = false;
    bool wearsFilm_ = true;
};

} // namespace dipwright

// Marks the body where the user clicks or draws with a brush: for the seam of two dips, for zones,
// or for masks. The view shows at once what the brush marks; the project changes when the stroke
// ends.
#pragma once

#include "marks/StrokePatch.h"
#include "workbench/dip/DipSession.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/view/DipScene.h"

namespace dipwright {

class MarkTool : public QObject {
    Q_OBJECT

public:
    MarkTool(DipView& view, DipScene& scene, const DipSession& session, QObject* parent = nullptr);

    // Without a brush, the tool ignores presses on the body.
    void setBrush(const MarkBrush& brush);

signals:
    void begun(); // a stroke; it is one undo step
    void ended();
    void refused(const QString& sentence); // the project cannot hold the mark

private:
    bool begins(const ViewRay& ray);
    void stroke(const ViewRay& ray);
    void addPoint(const SurfacePoint& place);
    void finish();
    void add(const std::function<void()>& marks); // says why if it throws Error
    void hover(const ViewRay& ray);
    void showDab(const SurfacePoint& place); // of the brush, before it is pressed
    void forget();                           // drops the stroke
    void show(const std::vector<StrokePatch>& parts, int opacity);
    void show(std::vector<std::array<Eigen::Vector3f, 3>> triangles, int opacity);
    MarkBrush brushNow() const; // an eraser while Shift is held
    BrushPoint pointAt(const SurfacePoint& place) const;
    // Name of the CAD face at a place; empty for other models. Marks with it stay on the face when
    // its triangles are made again.
    QString faceAt(const SurfacePoint& place) const;
    StrokePatch newPart() const;

    DipScene& scene_;
    const DipSession& session_;
    MarkBrush brush_;
    MarkBrush drawn_; // the brush of the stroke
    // The model that the stroke began on; null: no stroke. The parts refer to it, so that they go
    // when another model is shown.
    std::shared_ptr<const TexturedMesh> drawnOn_;
    // The parts of the stroke. It is interrupted where it jumps, for example past an edge.
    std::vector<StrokePatch> parts_;
    std::optional<ViewRay> lastRay_;
    std::optional<ViewRay> hovered_; // where the mouse is over the view
};

} // namespace dipwright

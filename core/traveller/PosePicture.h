// Draws a body as it hangs over the water, in parallel projection.
#pragma once

#include "dip/Pose.h"
#include "geometry/RefinedMesh.h"
#include "marks/SurfaceMask.h"
#include "results/PaintedBody.h"

#include <QImage>

namespace dipwright {

// Directions from which a pose is seen. Front: level, from the film's lower edge (looking along
// −Z). Right: level, from the film's right edge (looking along −X). Below: from below, with the
// film's upper edge up and its right edge on the left.
enum class PoseSide { Front, Right, Below };

struct PoseView {
    const PosedBody& body;
    const RefinedMesh& fine;              // of the body
    const PaintedBody& paint;             // on `fine`
    const TriangleMesh* cradle = nullptr; // in the body's frame; null or empty: no cradle
    const SurfaceMask* mask = nullptr;    // drawn as tape; null: nothing is masked
};

struct PosePicture {
    QImage image;      // white background
    double scale = 1;  // pixels per mm
    double bottom = 0; // y of the picture's lower edge, pose frame, mm
};

// Draws the whole body and cradle. Uses all cores. Deterministic. Throws Cancelled.
PosePicture posePicture(const PoseView& view, PoseSide side, QSize size, const Progress& progress);

} // namespace dipwright

// Draws a body as it hangs over the water, in parallel projection.
#pragma once

#include "dip/LaidFilm.h"
#include "results/Results.h"

#include <QImage>

namespace dipwright {

// Directions from which a pose is seen. Front: level, from the film's lower edge (looking along
// −Z). Right: level, from the film's right edge (looking along −X). Below: from below, with the
// film's upper edge up and its right edge on the left.
enum class PoseSide { Front, Right, Below };

struct PoseView {
    const PosedBody& body;
    const TriangleMesh* cradle = nullptr; // in the body's frame; null or empty: no cradle
    std::vector<FilmAppearance> films;    // films on the body; later ones lie over earlier ones
};

struct PosePicture {
    QImage image;      // white background
    double scale = 1;  // pixels per mm
    double bottom = 0; // y of the picture's lower edge, pose frame, mm
};

// Draws the whole body and cradle by casting rays on all cores. Deterministic. Throws Cancelled.
PosePicture posePicture(const PoseView& view, PoseSide side, QSize size, const Progress& progress);

} // namespace dipwright

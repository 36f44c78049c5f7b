// A body as it hangs over the water, drawn without perspective.
#pragma once

#include "dip/LaidFilm.h"
#include "results/Results.h"

#include <QImage>

namespace dipwright {

// The sides of a pose, seen level: from the film's lower edge (looking along −Z), and from its
// right one (along −X); and from below, turned over sideways, the film's upper edge up.
enum class PoseSide { Front, Right, Below };

struct PoseView {
    const PosedBody& body;
    const TriangleMesh* cradle = nullptr; // in the same frame; null or empty: none
    std::vector<FilmAppearance> films;    // what it wears, the later ones over the earlier
};

struct PosePicture {
    QImage image;      // white where nothing is
    double scale = 1;  // pixels a mm
    double bottom = 0; // of the picture's lower edge, pose frame, mm
};

// Without perspective, all of body and cradle. By rays on all cores; deterministic; throws
// Cancelled.
PosePicture posePicture(const PoseView& view, PoseSide side, QSize size, const Progress& progress);

} // namespace dipwright

// Draws a body as it hangs over the water, in parallel projection.
#pragma once

#include "dip/LaidFilm.h"
#include "marks/SurfaceMask.h"
#include "results/FilmPlaces.h"
#include "results/Results.h"

#include <QImage>

namespace dipwright {

// Directions from which a pose is seen. Front: level, from the film's lower edge (looking along
// −Z). Right: level, from the film's right edge (looking along −X). Below: from below, with the
// film's upper edge up and its right edge on the left.
enum class PoseSide { Front, Right, Below };

// A film on the body, and the table of its places on a refined mesh of the body. Without a table,
// each place is searched for.
struct PoseFilm {
    FilmAppearance appearance;
    std::shared_ptr<const FilmPlaces> places = nullptr;
};

struct PoseView {
    const PosedBody& body;
    const RefinedMesh& fine;              // of the body; the films' tables refer to it
    const TriangleMesh* cradle = nullptr; // in the body's frame; null or empty: no cradle
    std::vector<PoseFilm> films;          // later ones lie over earlier ones
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

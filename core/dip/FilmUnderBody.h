// Chooses the film's grid for a dip. The user sets the number of points, or the grid is adapted to
// the body in its pose. An adapted grid is as fine over the body as its narrow parts need, and
// coarse towards the film's edges (docs/film-model.md, "The film's cells").
#pragma once

#include "dip/Pose.h"
#include "settings/FilmSettings.h"

#include <Eigen/Geometry>

namespace dipwright {

// The faces of a body that meet the film in a pose: they face down, no other face is below them,
// and they go under water.
struct Underside {
    // Bounding box of the submerged part's shadow on the water, mm; without the offset. On a path,
    // of all places that it covers.
    Eigen::AlignedBox2d shadow;
    double longest = 0;    // longest side of the shadow at the end of the dip, mm
    double area = 0;       // area of the faces, mm²
    double shadowArea = 0; // area of the faces' shadow on the water, mm²
    // Thickness of the body that 90 % of the samples on these faces exceed, mm; 0 if there are no
    // samples.
    double thickness = 0;
};

// Finds the underside of a model in a dip. `query` searches `mesh`. Throws Error if the immersion's
// path cannot be travelled.
Underside undersideOf(const TriangleMesh& mesh, const SurfaceQuery& query,
                      const Immersion& immersion, const ProcessSettings& process);
Underside undersideOf(const PosedBody& body, const ProcessSettings& process);

// Returns the cell size that a film needs over the body.
Millimetres automaticCell(const Underside& underside, const FilmSettings& film);

// Whether the grid of a film is adapted to the body. For the paper's film model it never is.
bool isGraded(const FilmSettings& film);
// Whether a dip with this film is repeated with smaller cells until its sheet can be printed
// (pipeline/FilmRefinement.h).
bool isRefinable(const FilmSettings& film);

// Returns the width, in mm, of the strip of film round the body's shadow that the dip is expected
// to draw onto the body.
double drawIn(const Underside& underside);
// Returns a graded film. Its cells have the size `cell` over the body's shadow, over the strip
// round it that is drawn in, and over a margin of a few cells. `shadow` is Underside::shadow.
// Throws Error if the film would have more than maximumFilmGrid points.
solver::FilmGrid gradedFilm(const FilmSettings& film, const Eigen::AlignedBox2d& shadow,
                            double drawIn, Millimetres cell,
                            const std::array<Millimetres, 2>& offset);
// Returns the film for a dip with the body at an offset; filmGrid() if the film is not graded.
// Throws like gradedFilm().
solver::FilmGrid filmUnderBody(const FilmSettings& film, const Underside& underside,
                               const std::array<Millimetres, 2>& offset);

} // namespace dipwright

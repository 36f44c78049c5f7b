// The points of the film that a dip is done with: as many as the user says or, chosen for a body
// and its pose, as fine as its narrow parts need where it comes down on the film and coarse towards
// the film's edges (docs/film-model.md, "The film's cells").
#pragma once

#include "dip/Pose.h"
#include "settings/FilmSettings.h"

#include <Eigen/Geometry>

namespace dipwright {

// What the film meets of a body in a pose: the faces that turn down, without others below them, as
// far as they go under water.
struct Underside {
    Eigen::AlignedBox2d shadow; // on the water of all that goes under, mm, offset not included
    double area = 0;            // mm² of the faces …
    double shadowArea = 0;      // … and of their shadow
    double thickness = 0;       // mm through the body, that all but a tenth of them exceed; 0: none
};

// `query`: of `mesh`; `toPose`: from its coordinates to the pose frame.
Underside undersideOf(const TriangleMesh& mesh, const SurfaceQuery& query,
                      const Eigen::Isometry3d& toPose, const ProcessSettings& process);
Underside undersideOf(const PosedBody& body, const ProcessSettings& process);

// The side of the cells over the body, mm, that a film needs for it.
Millimetres automaticCell(const Underside& underside, const FilmSettings& film);

// Whether the points of a film depend on the body. Those of the paper's film never do.
bool isGraded(const FilmSettings& film);

// From how far beyond its shadow a body is expected to draw film in, mm.
double drawIn(const Underside& underside);
// A graded film with cells of a side over the body's shadow, over what is drawn in from round it
// and over a margin of some cells. `shadow`: as of an Underside. Throws Error where it would have
// more than maximumFilmGrid points.
solver::FilmGrid gradedFilm(const FilmSettings& film, const Eigen::AlignedBox2d& shadow,
                            double drawIn, Millimetres cell,
                            const std::array<Millimetres, 2>& offset);
// The film for a dip with the body at an offset; filmGrid() where it is not graded. Throws as
// gradedFilm() does.
solver::FilmGrid filmUnderBody(const FilmSettings& film, const Underside& underside,
                               const std::array<Millimetres, 2>& offset);

} // namespace dipwright

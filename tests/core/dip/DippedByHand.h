// Bodies with textures and films laid on them by closed forms, for tests without a solver.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

#include <functional>

namespace dipwright::test {

solver::FilmGrid a4Grid(int columns = 120, int rows = 170);
// Its lines half as far apart in the middle as at the edges, and a little more.
solver::FilmGrid gradedA4Grid(int columns = 120, int rows = 170);

// A body in the pose frame of an immersion as modelled.
PosedBody posed(const TriangleMesh& model);
// A film that is on such a body as a dip with `process` would have left it.
std::shared_ptr<const LaidFilm> laid(const TriangleMesh& model, const DippedFilm& film,
                                     const ProcessSettings& process = {});
// A letter F of three bars, black on white, in the upper left of its picture.
QImage letterF();
TexturedMesh plainModel(const TriangleMesh& mesh, const QColor& colour);

// A box whose outer bottom wears `picture`, upright for who looks at it from below with −Z up; its
// other faces have the material's colour.
TexturedMesh boxWithPicture(const Eigen::Vector3d& size, const QImage& picture);
// A sphere that wears `picture` as a map of the world does, south pole down; the map's left and
// right edges meet on the meridian of +Z.
TexturedMesh globe(double radius, int rings, int segments, const QImage& picture);
// A sphere whose two halves (x < 0 and x > 0) wear two charts seen along X, in the left and the
// right half of `picture`, a fifth of whose width lies between them and one tenth outside.
TexturedMesh halvedBall(double radius, int rings, int segments, const QImage& picture);

// Film that lies flat under a box of this size and is on it where it is under it.
DippedFilm flatUnderBox(const solver::FilmGrid& grid, const Eigen::Vector3d& size);
// Film with a law of its own: `polarAngle` of the place on the sphere where film that rested at a
// distance from the middle lies; beyond `end` (radians) the film is free.
DippedFilm onSphere(const solver::FilmGrid& grid, double radius, double end,
                    const std::function<double(double)>& polarAngle);
// Viscous film: R = 2ρ sin(θ/2) (docs/film-model.md, "Closed forms").
DippedFilm viscousOnSphere(const solver::FilmGrid& grid, double radius, double end);
// The same on a model of a sphere that is turned about X by so many degrees before the dip.
std::shared_ptr<const LaidFilm> laidOnTurnedSphere(const TriangleMesh& model, double radius,
                                                   double end, double turn);

} // namespace dipwright::test

// Bodies with textures and films laid on them by closed forms, for tests without a solver.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

#include <functional>

namespace dipwright::test {

solver::FilmGrid a4Grid(int columns = 120, int rows = 170);
// A graded film whose lines are about half as far apart in the middle as at the edges.
solver::FilmGrid gradedA4Grid(int columns = 120, int rows = 170);

// The body in the pose frame of an unturned dip.
PosedBody posed(const TriangleMesh& model);
// The film on such a body, laid as by a dip with `process`.
std::shared_ptr<const LaidFilm> laid(const TriangleMesh& model, const DippedFilm& film,
                                     const ProcessSettings& process = {});
// A letter F of three bars, black on white, in the upper left of its picture.
QImage letterF();
TexturedMesh plainModel(const TriangleMesh& mesh, const QColor& colour);

// A box with the texture `picture` on its bottom, upright seen from below with −Z up. Its other
// faces have the material's colour.
TexturedMesh boxWithPicture(const Eigen::Vector3d& size, const QImage& picture);
// A sphere with the texture `picture`, a map of the world, south pole down. The map's left and
// right edges meet on the meridian of +Z.
TexturedMesh globe(double radius, int rings, int segments, const QImage& picture);
// A sphere of two charts, its halves x < 0 and x > 0 seen along X. They lie in the left and the
// right half of `picture`, with a fifth of its width between them and a tenth outside.
TexturedMesh halvedBall(double radius, int rings, int segments, const QImage& picture);

// Film that lies flat under a box of this size and has adhered where it is under the box.
DippedFilm flatUnderBox(const solver::FilmGrid& grid, const Eigen::Vector3d& size);
// Film on a sphere. `polarAngle` gives the polar angle (radians) of film that rested at a distance
// (mm) from the middle. Beyond the polar angle `end` the film is free.
DippedFilm onSphere(const solver::FilmGrid& grid, double radius, double end,
                    const std::function<double(double)>& polarAngle);
// Viscous film: R = 2ρ sin(θ/2) (docs/film-model.md, "Closed forms").
DippedFilm viscousOnSphere(const solver::FilmGrid& grid, double radius, double end);
// Viscous film on a sphere that is turned about X by `turn` degrees before the dip.
std::shared_ptr<const LaidFilm> laidOnTurnedSphere(const TriangleMesh& model, double radius,
                                                   double end, double turn);

} // namespace dipwright::test

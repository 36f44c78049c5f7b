// Makes textured bodies, and films laid on them by closed forms, for tests without a solver.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

#include <functional>

namespace dipwright::test {

solver::FilmGrid a4Grid(int columns = 120, int rows = 170);
// A graded film whose lines are about half as far apart in the middle as at the edges.
solver::FilmGrid gradedA4Grid(int columns = 120, int rows = 170);

// Returns the body in the pose frame of a dip without rotation.
PosedBody posed(const TriangleMesh& model);
// Returns the film on such a body, as a dip with `process` would lay it.
std::shared_ptr<const LaidFilm> laid(const TriangleMesh& model, const DippedFilm& film,
                                     const ProcessSettings& process = {});
// Returns a picture of the letter F: three black bars on white, in the upper left.
QImage letterF();
TexturedMesh plainModel(const TriangleMesh& mesh, const QColor& colour);

// Returns a box whose bottom shows `picture`, upright when seen from below with −Z up. The other
// faces have the material's colour.
TexturedMesh boxWithPicture(const Eigen::Vector3d& size, const QImage& picture);
// Returns a sphere textured with `picture`, a map of the world; the south pole is down. The map's
// left and right edges meet on the meridian of +Z.
TexturedMesh globe(double radius, int rings, int segments, const QImage& picture);
// Returns a sphere of two charts: its halves x < 0 and x > 0, projected along X. The charts lie in
// the left and the right half of `picture`. A fifth of the picture's width is free between the
// charts, and a tenth on the outer side of each.
TexturedMesh halvedBall(double radius, int rings, int segments, const QImage& picture);

// Returns film that lies flat under a box of this size and has adhered to the box's bottom.
DippedFilm flatUnderBox(const solver::FilmGrid& grid, const Eigen::Vector3d& size);
// Returns film on a sphere. For film that rested at a distance (mm) from the film's middle,
// `polarAngle` gives the polar angle on the sphere (radians). Film beyond the polar angle `end` is
// free.
DippedFilm onSphere(const solver::FilmGrid& grid, double radius, double end,
                    const std::function<double(double)>& polarAngle);
// Returns viscous film on a sphere: R = 2ρ sin(θ/2) (docs/film-model.md, "Closed forms").
DippedFilm viscousOnSphere(const solver::FilmGrid& grid, double radius, double end);
// Returns viscous film on a sphere that is turned about X by `turn` degrees before the dip.
std::shared_ptr<const LaidFilm> laidOnTurnedSphere(const TriangleMesh& model, double radius,
                                                   double end, double turn);

} // namespace dipwright::test

// Applies deviations to the path of a dip (docs/film-model.md, "Tolerances"). Private to this
// folder.
#pragma once

#include "geometry/TriangleMesh.h"
#include "settings/DipPath.h"

#include <dipwright/FilmSolver.h>

#include <Eigen/Geometry>

namespace dipwright {

// Returns the path's angle changed by `degrees`, but no further than to the limits of the angles
// that can be travelled.
Degrees changedAngle(const DipPath& path, double degrees);

class ChangedPath {
public:
    // `path` has poses. It and `body` are in body coordinates. Keeps a reference to `body`.
    ChangedPath(solver::BodyPath path, const TriangleMesh& body);

    // The machine carries out the same motion, `speed` times as fast. The film moves with the
    // water, at `water` mm/s, so it has moved less far when the part arrives.
    void speedUp(double speed, const Eigen::Vector3d& water);
    // The part is held wrong: `held` moves it in its own coordinates. The machine's motion stays.
    void holdDifferently(const Eigen::Isometry3d& held);
    void move(double x, double z);
    // The whole motion turns about the vertical through the film's centre.
    void turn(const Eigen::Quaterniond& by);
    // Raises the water by `level` mm, but lowers it no further than to the lowest point at the end
    // of the dip. If the part would begin the dip too low, its motion is extended backwards.
    void raiseWater(double level);

    // Returns the path with its travel.
    solver::BodyPath path() const;

private:
    // Returns the height of the body's lowest point over the water.
    double lowest(const solver::PathPose& pose) const;
    void extendBackwards(double height);

    solver::BodyPath path_;
    const TriangleMesh& body_;
};

} // namespace dipwright

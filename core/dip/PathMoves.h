// Plans the motion of a part on its path: the poses between which it moves evenly. Private to this
// folder; BodyPath.h makes the solver's path of them.
#pragma once

#include "geometry/TriangleMesh.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <Eigen/Geometry>
#include <vector>

namespace dipwright {

// A pose of the part: its rotation relative to its final one, and the pivot's place relative to the
// offset, mm.
struct Move {
    double seconds = 0; // since the dip began
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
};

// The shape of the part that a path needs.
class PathShape {
public:
    // `posed` is the part in its pose frame (Pose.h).
    explicit PathShape(const TriangleMesh& posed);
    // The pivot, in the pose frame.
    const Eigen::Vector3d& middle() const { return middle_; }
    double height() const { return height_; }
    // Returns how far the lowest point of the turned part lies under its pivot.
    double below(const Eigen::Quaterniond& turn) const;
    // Returns the distance of the farthest point from the pivot.
    double radius() const;
    // Returns the distance of the farthest point from the horizontal axis across `heading`.
    double reachAcross(const Eigen::Vector3d& heading) const;

private:
    Eigen::Vector3d middle_;
    double height_ = 0;
    std::vector<Eigen::Vector3d> places_; // from the pivot
};

// Returns the length of the way between two moves, mm, above 0. No point of a part of this radius
// moves farther.
double wayBetween(const Move& from, const Move& to, double radius);

// Returns a horizontal unit vector.
Eigen::Vector3d directionOf(Degrees heading);

// Returns at least two moves. `depth` is the depth of the lowest point at the end of the way down,
// mm. Throws Error if the path cannot be travelled.
std::vector<Move> plannedMoves(const PathShape& shape, const Immersion& immersion,
                               const ProcessSettings& process, double depth);

} // namespace dipwright

// Computes the poses of a part over the time of a dip, from the path that the user chose
// (settings/DipPath.h).
//
// A path is given in the pose frame (Pose.h) at the end of the dip, moved by the offset on the
// water. In this frame the part has its final rotation. The pivot lies on the pose frame's vertical
// axis, at half the part's height. docs/film-model.md, "Paths", derives the poses of each kind.
#pragma once

#include "geometry/TriangleMesh.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <dipwright/FilmSolver.h>

#include <Eigen/Geometry>
#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

Eigen::Quaterniond rotationOf(const solver::PathPose& pose);
// Returns the map from the body's coordinates to the world after it has travelled `travelled` mm.
// `path` must have poses.
Eigen::Isometry3d placeOnPath(const solver::BodyPath& path, double travelled);
// Returns the time since the dip began, s. `path` must have poses.
double secondsOnPath(const solver::BodyPath& path, double travelled);
// Returns the distance, mm, that the body has travelled after `seconds`. `path` must have poses.
double travelledAfter(const solver::BodyPath& path, double seconds);
// Returns the distance, mm, that the body has travelled when the place `at` of the body first goes
// under water; nothing if it stays above.
std::optional<double> firstUnderWater(const solver::BodyPath& path, const Eigen::Vector3d& at);

// Returns the height of the lowest point of a body over the water, mm.
double lowestPoint(const TriangleMesh& body, const Eigen::Isometry3d& toWorld);

// Returns `angle`, or the nearest angle with which a path of this kind can be travelled.
Degrees travellableAngle(PathKind kind, Degrees angle);

// Sets PathPose::travelled of all poses. `radius` is the distance of the body's farthest point from
// the pivot, mm.
void measureTravel(std::vector<solver::PathPose>& poses, double radius);

// Returns the path of a body in the coordinates of its pose frame, without the offset on the water;
// without poses if the part goes straight down. `posed` is the body in its pose frame. Throws Error
// if the path cannot be travelled.
solver::BodyPath bodyPath(const TriangleMesh& posed, const Immersion& immersion,
                          const ProcessSettings& process);
// Returns the same path, at an offset on the water, for a body in other coordinates: model or body
// coordinates (geometry/FieldGrid.h). `toPose` maps them to the pose frame.
solver::BodyPath pathOfModel(const solver::BodyPath& path, const Eigen::Isometry3d& toPose,
                             const Immersion& immersion);

// The speed of the travel on a path, mm/s.
struct PathSpeed {
    double mean = 0; // over the whole path
    double most = 0; // the highest mean between two poses
};
// Returns it. `path` must have poses.
PathSpeed speedOnPath(const solver::BodyPath& path);

// Returns how far the body comes up again on its path: how much its lowest point rises, as a share
// of its greatest depth before. 0: it never rises; 1: it comes up to the water, more: above it.
// `posed` is the body in its pose frame.
double riseOnPath(const solver::BodyPath& path, const TriangleMesh& posed);

// Returns how far a body travels at most, mm, between two moments at which its shadow is computed.
double shadowStep(const TriangleMesh& posed);
// The part of a body whose shadow is computed.
enum class ShadowOf : std::uint8_t { Whole, UnderWater };
// Returns the bounding box, in x and z, of a body, or of its part under water.
Eigen::AlignedBox2d shadowAt(const TriangleMesh& body, const Eigen::Isometry3d& toWorld,
                             ShadowOf part);
// Returns the bounding box, in x and z from the offset, of the body on its path, or of the places
// at which it is under water. `posed` is the body in its pose frame.
Eigen::AlignedBox2d shadowOnPath(const solver::BodyPath& path, const TriangleMesh& posed,
                                 ShadowOf part);

// Returns the direction of the vertical, in the body's frame, when a place first goes under water.
// If it never does, returns the direction at the end of the dip. Straight down: +Y.
Eigen::Vector3d upAtWater(const solver::BodyPath& path, const Eigen::Vector3d& at);
// Whether the direction of the vertical in the body's frame changes by more than about 1° on the
// path.
bool isTilting(const solver::BodyPath& path);

// Returns the velocity of the water on this path, mm/s, in the pose frame.
Eigen::Vector3d waterVelocity(const DipPath& path);

// Returns a few words on a path for the user, "tilted by 20°, heading 45°"; empty if the part goes
// straight down.
QString pathText(const DipPath& path);

// A moment on a path at which the body's rotation is examined.
struct PathMoment {
    double travelled = 0;
    Eigen::Isometry3d poseToWorld;
};
// Returns moments on a path between which the body turns by a few degrees at most, and travels
// `most` mm at most.
std::vector<PathMoment> momentsOf(const solver::BodyPath& path, double most);

} // namespace dipwright

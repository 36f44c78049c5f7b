// Places a body over the film: pose, frames, depth and travel of a dip.
//
// Pose frame: the body rotated about the centre of its bounding box by X, then Y, then Z (fixed
// axes). That centre is at x = z = 0 and the lowest point at y = 0. Results are written in this
// frame. The solver's world frame has its waterline at y = 0. It differs from the pose frame by the
// offset of the body on the water and by its descent (poseToWorld). On a path (BodyPath.h) it also
// differs by a rotation, which is none at the end of the dip.
#pragma once

#include "base/Units.h"
#include "dip/AirPockets.h"
#include "dip/BodyPath.h"
#include "geometry/BuriedSurface.h"
#include "geometry/SurfaceQuery.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <array>

namespace dipwright {

// Returns the rotation by angles about X, then Y, then Z.
Eigen::Matrix3d rotationMatrix(const std::array<Degrees, 3>& angles);
// Returns the angles about X, then Y, then Z of a rotation, rounded to 0.1°. If several sets of
// angles within ±360° give the rotation, returns the set nearest to `near`.
std::array<Degrees, 3> rotationAngles(const Eigen::Matrix3d& rotation,
                                      const std::array<Degrees, 3>& near = {});

// Returns the angles about X, then Y, then Z of a rotation, in radians: the set nearest to `aim`.
Eigen::Vector3d anglesNear(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& aim);

// Maps model coordinates to the pose frame.
Eigen::Isometry3d poseTransform(const TriangleMesh& model, const Immersion& immersion);
// Maps body coordinates (geometry/FieldGrid.h) to the pose frame.
Eigen::Isometry3d bodyTransform(const TriangleMesh& model, const Immersion& immersion);

// The shape of a body in the pose frame of one dip, with its surface query, its path and its air
// pockets. It depends neither on the offset on the water nor on the body's appearance.
struct PosedBody {
    TriangleMesh mesh;             // the model's mesh in the pose frame
    Eigen::Isometry3d modelToPose; // maps model coordinates to the pose frame
    // Maps body coordinates, in which distance fields are given, to the pose frame.
    Eigen::Isometry3d bodyToPose;
    double height = 0;     // from the lowest to the highest point, mm
    SurfaceQuery query;    // searches `mesh`
    AirPockets air;        // air pockets of `mesh`
    solver::BodyPath path; // without the offset on the water; no poses if it goes straight down
    BuriedSurface buried = {};
    // Whether an air pocket keeps film off a place on the body.
    bool isDry(const SurfacePoint& point) const;
    // Whether a place is inside another part of the body, where there is nothing to paint.
    bool isBuried(const SurfacePoint& point) const;
};
// Air pockets are searched for on a grid with `cells` cells along the body's longest edge. Uses all
// cores; deterministic. Throws Error if the immersion's path cannot be travelled.
PosedBody posedBody(const TriangleMesh& model, const Immersion& immersion,
                    const ProcessSettings& process, int cells = airCells);
// Does the same for a body that goes straight down, whatever the immersion's path.
PosedBody posedBody(const TriangleMesh& model, const Immersion& immersion, int cells = airCells);

// Distance of the body's lowest point above the water before the dip, mm.
inline constexpr double startHeight = 0.5;
// Returns the height of the water above the body's lowest point at the end of the dip, mm. This is
// the depth that the process sets or, if it sets none, the body's height plus a margin.
double dipDepth(const ProcessSettings& process, const PosedBody& body);
// Returns the same for a body of this height, mm.
double dipDepth(const ProcessSettings& process, double height);
// Returns the total travel of the body, mm; on a path, the length of the path.
double dipTravel(const ProcessSettings& process, const PosedBody& body);
// Returns the translation from the pose frame to the world frame after `descent` mm straight down.
Eigen::Vector3d poseToWorld(const Immersion& immersion, double descent);
// Returns the map from the pose frame to the world frame after the body has descended, or has
// travelled along its path, by this distance. `path` is PosedBody::path.
Eigen::Isometry3d poseToWorld(const solver::BodyPath& path, const Immersion& immersion,
                              double travelled);

} // namespace dipwright

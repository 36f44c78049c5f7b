// How a body is held over the film.
//
// Pose frame: the body rotated about its bounding box's centre by X, then Y, then Z (fixed axes),
// that centre at x = z = 0, the lowest point of the rotated body at y = 0. Results are written in
// this frame. The world frame of the solver, whose waterline is y = 0, differs from it by the
// immersion's offset on the water and by how far the body has come down (poseToWorld).
#pragma once

#include "base/Units.h"
#include "dip/AirPockets.h"
#include "geometry/SurfaceQuery.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <array>

namespace dipwright {

// The rotation by angles about X, then Y, then Z, and such angles for a rotation, to a tenth of a
// degree: of all that there are those nearest to `near`, but within a whole turn.
Eigen::Matrix3d rotationMatrix(const std::array<Degrees, 3>& angles);
std::array<Degrees, 3> rotationAngles(const Eigen::Matrix3d& rotation,
                                      const std::array<Degrees, 3>& near = {});

// Model coordinates to the pose frame.
Eigen::Isometry3d poseTransform(const TriangleMesh& body, const Immersion& immersion);

// The shape of a body in the pose frame of one immersion, with what asks its surface questions and
// the air that it takes under water. It does not depend on the immersion's offset, nor on what the
// body looks like.
struct PosedBody {
    TriangleMesh mesh;             // the model's, in the pose frame
    Eigen::Isometry3d modelToPose; // from the coordinates of the model and its distance field
    double height = 0;             // mm from the lowest to the highest point
    SurfaceQuery query;            // of mesh
    AirPockets air;                // of mesh
    // Whether the air keeps film off a place of the body.
    bool isDry(const SurfacePoint& point) const;
};
// Air is looked for on so many cells along the body's longest edge. All cores, deterministic.
PosedBody posedBody(const TriangleMesh& model, const Immersion& immersion, int cells = airCells);

// mm between the body's lowest point and the water before the dip.
inline constexpr double startHeight = 0.5;
// How far up the body the water reaches at the end of the dip, mm from its lowest point: the
// process's depth or, where that is none, past all of the body by a margin.
double dipDepth(const ProcessSettings& process, const PosedBody& body);
// mm that the body comes down in all.
double dipTravel(const ProcessSettings& process, const PosedBody& body);
// The shift from the pose frame to the world when the body has come down by `descent` mm.
Eigen::Vector3d poseToWorld(const Immersion& immersion, double descent);

} // namespace dipwright

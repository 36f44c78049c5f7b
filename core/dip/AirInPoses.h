// Estimates where a model would trap air in any pose. The estimate is coarse; it is used to choose
// between poses. A dip itself uses AirPockets.h.
#pragma once

#include "geometry/TriangleMesh.h"

#include <memory>

namespace dipwright {

class SpaceGrid;

// Construct it once per model, then query it for each pose. Immutable; any thread may query it.
// Deterministic.
class AirInPoses {
public:
    explicit AirInPoses(const TriangleMesh& model);

    // Returns one entry per triangle of the model: 1 if the triangle's middle stays in air. `up` is
    // a unit vector in the model's coordinates. Accurate to about 1/40 of the model's longest edge.
    std::vector<std::uint8_t> dry(const Eigen::Vector3f& up) const;

private:
    std::shared_ptr<const SpaceGrid> grid_;
    std::vector<std::uint32_t> before_; // for each triangle, the grid point in front of it
};

} // namespace dipwright

// Where a model would trap air in any pose, coarsely: for choosing among poses before any is
// dipped. What a dip in one pose reckons with is AirPockets.h.
#pragma once

#include "geometry/TriangleMesh.h"

#include <memory>

namespace dipwright {

class SpaceGrid;

// Made once for a model, asked for each pose. Immutable; any thread may ask. Deterministic.
class AirInPoses {
public:
    explicit AirInPoses(const TriangleMesh& model);

    // A triangle of the model each: 1 where its middle stays in air. `up`: unit, in the model's
    // coordinates. Right up to about a fortieth of the model's longest edge.
    std::vector<std::uint8_t> dry(const Eigen::Vector3f& up) const;

private:
    std::shared_ptr<const SpaceGrid> grid_;
    std::vector<std::uint32_t> before_; // the grid's point before each triangle
};

} // namespace dipwright

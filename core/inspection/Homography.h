// From a plane to a picture without distortion. Private to this folder.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace dipwright {

// Where the plane's place appears.
Eigen::Vector2d projected(const Eigen::Matrix3d& homography, const Eigen::Vector2d& place);

// The one that takes each of `plane` nearest to the same one of `picture`, by the linear method on
// places moved and scaled to the order of 1 (R. Hartley, "In Defense of the Eight-Point Algorithm",
// 1997); the last element 1. At least four pairs, not on one line: else what comes out is of no
// use.
Eigen::Matrix3d linearHomography(const std::vector<Eigen::Vector2d>& plane,
                                 const std::vector<Eigen::Vector2d>& picture);

} // namespace dipwright

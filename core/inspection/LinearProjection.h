// From places in a plane or in space to a picture without distortion. Private to this folder.
#pragma once

#include <Eigen/Core>

namespace dipwright {

// Where the plane's place appears.
Eigen::Vector2d projected(const Eigen::Matrix3d& homography, const Eigen::Vector2d& place);

// The matrix that takes each column of `places` nearest to the same column of `picture`, by the
// linear method on places moved and scaled to the order of 1 (R. Hartley, "In Defense of the
// Eight-Point Algorithm", 1997): 3 × 3 from a plane, for at least four pairs that are not on one
// line; 3 × 4 from space, for at least six that are not in one plane. For fewer the result is of no
// use. Its factor is arbitrary.
Eigen::Matrix3Xd linearProjection(const Eigen::MatrixXd& places, const Eigen::Matrix2Xd& picture);

} // namespace dipwright

// Projects places in a plane or in space to a picture without distortion. Private to this folder.
#pragma once

#include <Eigen/Core>

namespace dipwright {

// Returns where a place of the plane appears in the picture.
Eigen::Vector2d projected(const Eigen::Matrix3d& homography, const Eigen::Vector2d& place);

// Returns the matrix that best maps each column of `places` to the same column of `picture`. For
// places in a plane it is 3 × 3 and needs at least four pairs that are not on one line. For places
// in space it is 3 × 4 and needs at least six pairs that are not in one plane. With fewer pairs the
// result is useless. The scale of the matrix is arbitrary. Uses the linear method with normalised
// places (R. Hartley, "In Defense of the Eight-Point Algorithm", 1997).
Eigen::Matrix3Xd linearProjection(const Eigen::MatrixXd& places, const Eigen::Matrix2Xd& picture);

} // namespace dipwright

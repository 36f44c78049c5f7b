#include "inspection/LinearProjection.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>

namespace dipwright {

namespace {

// Moves the places' mean to the origin and makes their mean distance from it 1.
Eigen::MatrixXd normalising(const Eigen::MatrixXd& places) {
    const Eigen::VectorXd mean = places.rowwise().mean();
    const double distance = (places.colwise() - mean).colwise().norm().mean();
    const Eigen::Index size = places.rows();
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(size + 1, size + 1);
    map.topRightCorner(size, 1) = -mean;
    map.topRows(size) /= std::max(distance, 1e-12);
    return map;
}

} // namespace

Eigen::Vector2d projected(const Eigen::Matrix3d& homography, const Eigen::Vector2d& place) {
    return (homography * place.homogeneous()).hnormalized();
}

Eigen::Matrix3Xd linearProjection(const Eigen::MatrixXd& places, const Eigen::Matrix2Xd& picture) {
    const Eigen::MatrixXd fromPlaces = normalising(places);
    const Eigen::Matrix3d fromPicture = normalising(picture);
    const Eigen::Index size = places.rows() + 1;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * places.cols(), 3 * size);
    for (Eigen::Index i = 0; i < places.cols(); ++i) {
        const Eigen::RowVectorXd from = (fromPlaces * places.col(i).homogeneous()).transpose();
        const Eigen::Vector2d to = projected(fromPicture, picture.col(i));
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            rows.block(2 * i + axis, axis * size, 1, size) = from;
            rows.block(2 * i + axis, 2 * size, 1, size) = -to[axis] * from;
        }
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
    const Eigen::MatrixXd least = svd.matrixV().rightCols<1>().reshaped(size, 3).transpose();
    return fromPicture.inverse() * least * fromPlaces;
}

} // namespace dipwright

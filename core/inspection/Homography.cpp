#include "inspection/Homography.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>

namespace dipwright {

namespace {

// Moves the places' mean to the origin and makes their mean distance from it 1.
Eigen::Matrix3d normalising(const std::vector<Eigen::Vector2d>& places) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places) {
        mean += place / double(places.size());
    }
    double distance = 0;
    for (const Eigen::Vector2d& place : places) {
        distance += (place - mean).norm() / double(places.size());
    }
    const double scale = 1 / std::max(distance, 1e-12);
    Eigen::Matrix3d map;
    map << scale, 0, -scale * mean.x(), 0, scale, -scale * mean.y(), 0, 0, 1;
    return map;
}

} // namespace

Eigen::Vector2d projected(const Eigen::Matrix3d& homography, const Eigen::Vector2d& place) {
    return (homography * place.homogeneous()).hnormalized();
}

Eigen::Matrix3d linearHomography(const std::vector<Eigen::Vector2d>& plane,
                                 const std::vector<Eigen::Vector2d>& picture) {
    const Eigen::Matrix3d fromPlane = normalising(plane), fromPicture = normalising(picture);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(Eigen::Index(2 * plane.size()), 9);
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const Eigen::RowVector3d from = (fromPlane * plane[i].homogeneous()).transpose();
        const Eigen::Vector2d to = projected(fromPicture, picture[i]);
        const auto row = Eigen::Index(2 * i);
        rows.block<1, 3>(row, 0) = from;
        rows.block<1, 3>(row, 6) = -to.x() * from;
        rows.block<1, 3>(row + 1, 3) = from;
        rows.block<1, 3>(row + 1, 6) = -to.y() * from;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeFullV);
    const Eigen::VectorXd least = svd.matrixV().col(8);
    Eigen::Matrix3d map;
    map << least[0], least[1], least[2], least[3], least[4], least[5], least[6], least[7], least[8];
    const Eigen::Matrix3d whole = fromPicture.inverse() * map * fromPlane;
    return whole / whole(2, 2);
}

} // namespace dipwright

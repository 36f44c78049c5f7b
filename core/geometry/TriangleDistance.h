// Distances of triangles.
#pragma once

#include <Eigen/Core>
#include <array>

namespace dipwright {

// Returns the weights of the point of triangle abc nearest to p.
Eigen::Vector3d closestWeights(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& c);

// Returns the distance between two triangles. If they pierce each other, their borders count.
double triangleDistance(const std::array<Eigen::Vector3f, 3>& one,
                        const std::array<Eigen::Vector3f, 3>& other);

} // namespace dipwright

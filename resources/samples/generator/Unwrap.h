// Laying pieces of a surface flat, as texture charts.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright::samples {

// Lays the triangles `piece` of the mesh into the plane, each as near its true shape as it goes,
// counterclockwise seen from outside; begins with `flat`, a place for every position of the mesh.
// Throws std::runtime_error if a triangle folds.
std::vector<Eigen::Vector2f> unwrap(const TriangleMesh& mesh,
                                    const std::vector<std::uint32_t>& piece,
                                    std::vector<Eigen::Vector2f> flat);

} // namespace dipwright::samples

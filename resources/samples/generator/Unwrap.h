// Flattens pieces of a surface into texture charts.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright::samples {

// Flattens the triangles `piece` of the mesh, each as close to its true shape as possible. They are
// counterclockwise as seen from outside. Starts from `flat`, which has one place for each mesh
// position. Throws std::runtime_error if a triangle folds.
std::vector<Eigen::Vector2f> unwrap(const TriangleMesh& mesh,
                                    const std::vector<std::uint32_t>& piece,
                                    std::vector<Eigen::Vector2f> flat);

} // namespace dipwright::samples

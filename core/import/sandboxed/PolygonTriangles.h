// Cuts the polygons of a mesh into triangles. Private to this folder. assimp does this only for
// files that it reads itself.
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace dipwright {

// Three corners of a polygon, by number.
using PolygonTriangle = std::array<std::size_t, 3>;

// Whether the fan of triangles from the first corner folds over itself. Rounding does not count.
bool isFoldedFan(const std::vector<Eigen::Vector3f>& polygon);

// Returns triangles that fill a polygon, turned as it is; nothing if its edges cross each other.
// The number of triangles is that of the fan. Time grows with the square of the corners. Method:
// Meisters, "Polygons have ears", 1975.
std::optional<std::vector<PolygonTriangle>> cutPolygon(const std::vector<Eigen::Vector3f>& polygon);

} // namespace dipwright

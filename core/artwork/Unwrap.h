// Computes texture coordinates for meshes that have none, or none that can be painted on.
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// A mesh cut into charts that are packed side by side into one picture.
struct Unwrapping {
    static constexpr std::uint32_t nobody = 0xffffffffu;

    double texel = 0; // side of a texel where the surface is parallel to its chart, mm
    int width = 0, height = 0;
    // Per triangle: its corners in texels from the upper left.
    std::vector<std::array<Eigen::Vector2f, 3>> corners;
    std::vector<std::uint32_t> chart; // per triangle: its chart
    // Per texel, row by row: the triangle that it shows. Texels in the margin round a chart show
    // its nearest triangle; texels between charts are `nobody`.
    std::vector<std::uint32_t> owner;
};

// Unwraps a mesh. A chart grows over triangles whose normals are within 50° of its mean normal, and
// is laid flat along that normal. A triangle that would overlap its own chart starts a new one. So
// no texel's middle is in two triangles, except on their common edge.
// The first charts start at the triangles `begins`, to keep the surface round them in one piece.
// Texels are about `texel` mm, or larger if there would be more than `mostTexels`. Deterministic;
// throws Cancelled.
Unwrapping unwrapped(const TriangleMesh& mesh, const std::vector<std::uint32_t>& begins,
                     double texel, qint64 mostTexels, const Progress& progress);

} // namespace dipwright

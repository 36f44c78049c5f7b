// Texture coordinates for meshes that have none, or whose own cannot be painted on.
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// A mesh cut into charts that lie beside each other in one picture.
struct Unwrapping {
    static constexpr std::uint32_t nobody = 0xffffffffu;

    double texel = 0; // mm a side, where a surface is not aslant to its chart
    int width = 0, height = 0;
    std::vector<std::array<Eigen::Vector2f, 3>> corners; // of triangles, texels from the upper left
    std::vector<std::uint32_t> chart;                    // a triangle each
    // A texel each, row by row: the triangle that it shows. Round a chart the texels of a margin
    // show its nearest triangle; nobody: between the charts.
    std::vector<std::uint32_t> owner;
};

// Charts grow over triangles that look the same way, to 50°, and are laid flat along the mean of
// how they look; what would lie over another part of the same chart begins one of its own. So no
// texel's middle is in two triangles, but on their common edge. The first charts begin with these
// triangles, so that what lies round them is cut as little as can be. Texels of about `texel` mm,
// larger where there would be more than `mostTexels`. Deterministic; throws Cancelled.
Unwrapping unwrapped(const TriangleMesh& mesh, const std::vector<std::uint32_t>& begins,
                     double texel, qint64 mostTexels, const Progress& progress);

} // namespace dipwright

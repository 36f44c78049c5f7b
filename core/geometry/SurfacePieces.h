// Finds the connected pieces of a part of a surface.
#pragma once

#include "geometry/TriangleMesh.h"

#include <functional>

namespace dipwright {

struct SurfacePiece {
    double area = 0; // mm²
    std::uint32_t middle =
        0; // the triangle of the piece whose middle is nearest to the piece's mean
};

// Returns the pieces of at least `leastArea` (mm²) of the triangles for which `belongs` is true,
// the largest first. `opposite`: oppositeEdges() of the mesh. Calls `belongs` several times for
// each triangle.
std::vector<SurfacePiece> surfacePieces(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& opposite,
                                        const std::function<bool(std::uint32_t)>& belongs,
                                        double leastArea);

} // namespace dipwright

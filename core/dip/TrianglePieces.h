// Samples the area of a triangle evenly.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Cuts a triangle into pieces² congruent triangles and calls visit(SurfacePoint) with the middle of
// each.
template <typename Visit>
void forEachPiece(std::uint32_t triangle, int pieces, const Visit& visit) {
    for (int row = 0; row < pieces; ++row) {
        for (int place = 0; place < 2 * row + 1; ++place) {
            // Within a row, pieces alternate between pointing to the first corner and away from it.
            const bool upright = place % 2 == 0;
            const float depth = float(row) + (upright ? 2.0f : 1.0f) / 3;
            const int before = place / 2; // pieces with the same orientation before it in the row
            const float across = float(before) + (upright ? 1.0f : 2.0f) / 3;
            const auto count = float(pieces);
            visit(SurfacePoint{triangle,
                               {1 - depth / count, (depth - across) / count, across / count}});
        }
    }
}

} // namespace dipwright

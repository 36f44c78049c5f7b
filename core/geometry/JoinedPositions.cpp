#include "geometry/JoinedPositions.h"

#include <algorithm>
#include <numeric>

namespace dipwright {

JoinedPositions::JoinedPositions(std::size_t positions) : parent_(positions) {
    std::iota(parent_.begin(), parent_.end(), 0U);
}

JoinedPositions::JoinedPositions(const TriangleMesh& mesh)
    : JoinedPositions(mesh.positions.size()) {
    for (const auto& [a, b, c] : mesh.triangles) {
        join(a, b);
        join(b, c);
    }
}

std::uint32_t JoinedPositions::pieceOf(std::uint32_t position) {
    while (parent_[position] != position) {
        position = parent_[position] = parent_[parent_[position]];
    }
    return position;
}

void JoinedPositions::join(std::uint32_t one, std::uint32_t other) {
    const auto [lower, higher] = std::minmax({pieceOf(one), pieceOf(other)});
    parent_[higher] = lower;
}

} // namespace dipwright

// Groups of positions that triangles connect.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Each group is identified by one of its positions. Source: union–find with path halving.
class JoinedPositions {
public:
    explicit JoinedPositions(const TriangleMesh& mesh);

    // Returns the position that identifies the group. Not thread-safe.
    std::uint32_t pieceOf(std::uint32_t position);

private:
    void join(std::uint32_t one, std::uint32_t other);

    std::vector<std::uint32_t> parent_;
};

} // namespace dipwright

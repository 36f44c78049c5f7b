// Groups of positions that are connected, for example by triangles.
#pragma once

#include "geometry/TriangleMesh.h"

namespace dipwright {

// Each group is identified by the lowest of its positions. Source: union–find with path halving.
class JoinedPositions {
public:
    explicit JoinedPositions(std::size_t positions); // each is a group of its own
    explicit JoinedPositions(const TriangleMesh& mesh);

    void join(std::uint32_t one, std::uint32_t other);

    // Returns the position that identifies the group. Not thread-safe.
    std::uint32_t pieceOf(std::uint32_t position);

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace dipwright

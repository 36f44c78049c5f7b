#include "geometry/Solid.h"

#include <algorithm>
#include <utility>

namespace dipwright {

bool boundsSolid(const TriangleMesh& mesh) {
    if (isClosed(mesh)) {
        return true;
    }
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<Edge> along, against;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            along.emplace_back(triangle[i], triangle[(i + 1) % 3]);
            against.emplace_back(triangle[(i + 1) % 3], triangle[i]);
        }
    }
    std::sort(along.begin(), along.end());
    std::sort(against.begin(), against.end());
    return !along.empty() && along == against;
}

} // namespace dipwright

#include "geometry/RefinedMesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <Eigen/LU>

namespace dipwright {
namespace {

constexpr double fineTriangles = 40'000; // number of triangles of fineBody()
constexpr std::uint32_t noMiddle = 0xffffffffu;

using Triangle = std::array<std::uint32_t, 3>;
using Line = std::array<std::uint32_t, 2>; // the indices of its two ends

// Midpoints of the edges that were cut.
class Middles {
public:
    Middles(std::vector<Eigen::Vector3f>& positions, const RefinedMesh::TooLong& isTooLong)
        : positions_(positions), isTooLong_(isTooLong) {}

    // Returns the midpoint of an edge. Creates it if the edge is too long and has none.
    std::uint32_t of(std::uint32_t from, std::uint32_t to) {
        const auto [low, high] = std::minmax(from, to); // in one order for both triangles
        const Eigen::Vector3f a = positions_[low];
        const Eigen::Vector3f b = positions_[high];
        if (!isTooLong_(a, b)) {
            return noMiddle;
        }
        const auto [found, isNew] =
            middles_.try_emplace(std::uint64_t(low) << 32 | high, std::uint32_t(positions_.size()));
        if (isNew) {
            positions_.push_back((a + b) / 2);
        }
        return found->second;
    }

private:
    std::vector<Eigen::Vector3f>& positions_;
    const RefinedMesh::TooLong& isTooLong_;
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

// Returns the triangles into which a triangle is cut. Points 0, 1, 2 are its corners; point 3 + e
// is the midpoint of edge e, if that edge has one. If two edges have midpoints, there are two ways
// to cut; `isShorter` chooses the shorter line.
std::vector<Triangle> cut(const Triangle& middles, const auto& isShorter) {
    std::vector<std::uint32_t> edges;
    for (std::uint32_t edge = 0; edge < 3; ++edge) {
        if (middles[edge] != noMiddle) {
            edges.push_back(edge);
        }
    }
    if (edges.empty()) {
        return {{0, 1, 2}};
    }
    if (edges.size() == 3) {
        return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    }
    const auto next = [](std::uint32_t k) { return (k + 1) % 3; };
    if (edges.size() == 1) {
        const std::uint32_t e = edges.front();
        return {{e, 3 + e, next(next(e))}, {3 + e, next(e), next(next(e))}};
    }
    const std::uint32_t e = next(edges[0]) == edges[1] ? edges[0] : edges[1];
    const std::uint32_t f = next(e);
    const std::uint32_t last = next(f);
    std::vector<Triangle> parts{{3 + e, f, 3 + f}};
    if (isShorter(Line{3 + e, last}, Line{e, 3 + f})) {
        parts.push_back({e, 3 + e, last});
        parts.push_back({3 + e, 3 + f, last});
    } else {
        parts.push_back({e, 3 + e, 3 + f});
        parts.push_back({e, 3 + f, last});
    }
    return parts;
}

// A triangle that may have to be cut, with the part and the coarse triangle it belongs to.
struct Open {
    Triangle corners;
    std::uint32_t part, parent;
};

// Returns cut()'s points of a triangle as weights in the coarse triangle, one column for each.
Eigen::Matrix<float, 3, 6> pointsOf(const Eigen::Matrix3f& corners) {
    Eigen::Matrix<float, 3, 6> points;
    points.leftCols<3>() = corners;
    for (int edge = 0; edge < 3; ++edge) {
        points.col(3 + edge) = (corners.col(edge) + corners.col((edge + 1) % 3)) / 2;
    }
    return points;
}

} // namespace

float edgeForTriangles(const TriangleMesh& mesh, double triangles) {
    // Bisection leaves edges between half the longest and the longest.
    const double area = surfaceArea(mesh) / triangles;
    return float(std::max(1.5 * std::sqrt(4 * area / std::sqrt(3.0)), 1e-3));
}

float fineEdge(const TriangleMesh& body) {
    return edgeForTriangles(body, fineTriangles);
}

std::shared_ptr<const RefinedMesh> fineBody(const TriangleMesh& body) {
    return std::make_shared<const RefinedMesh>(body, fineEdge(body));
}

RefinedMesh::RefinedMesh(const TriangleMesh& coarse, float longestEdge)
    : RefinedMesh(coarse, [longestEdge](const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
          return (to - from).norm() > longestEdge;
      }) {}

RefinedMesh::RefinedMesh(const TriangleMesh& coarse, const TooLong& isTooLong) {
    mesh_.positions = coarse.positions;
    std::vector<Open> open;
    for (std::uint32_t triangle = 0; triangle < coarse.triangles.size(); ++triangle) {
        parts_.push_back({Corners::Identity()});
        open.push_back({coarse.triangles[triangle], triangle, triangle});
    }
    while (!open.empty()) {
        Middles middles(mesh_.positions, isTooLong);
        std::vector<Open> cutAgain;
        for (const Open& whole : open) {
            std::array<std::uint32_t, 6> points{whole.corners[0], whole.corners[1],
                                                whole.corners[2]};
            Triangle made;
            for (std::size_t edge = 0; edge < 3; ++edge) {
                made[edge] = middles.of(whole.corners[edge], whole.corners[(edge + 1) % 3]);
                points[3 + edge] = made[edge];
            }
            const auto length = [&](const Line& line) {
                return (mesh_.positions[points[line[0]]] - mesh_.positions[points[line[1]]])
                    .squaredNorm();
            };
            const std::vector<Triangle> parts =
                cut(made, [&](const Line& a, const Line& b) { return length(a) < length(b); });
            if (parts.size() == 1) {
                parts_[whole.part].first = std::uint32_t(mesh_.triangles.size());
                mesh_.triangles.push_back(whole.corners);
                parents_.push_back(whole.parent);
                fineParts_.push_back(whole.part);
                continue;
            }
            const auto weights = pointsOf(parts_[whole.part].corners);
            parts_[whole.part].first = std::uint32_t(parts_.size());
            parts_[whole.part].count = std::uint32_t(parts.size());
            for (const auto& [a, b, c] : parts) {
                Part inner;
                inner.corners << weights.col(a), weights.col(b), weights.col(c);
                cutAgain.push_back({{points[a], points[b], points[c]},
                                    std::uint32_t(parts_.size()),
                                    whole.parent});
                parts_.push_back(inner);
            }
        }
        open = std::move(cutAgain);
    }
}

SurfacePoint RefinedMesh::middle(std::size_t triangle) const {
    return onCoarse(middleOf(std::uint32_t(triangle)));
}

SurfacePoint RefinedMesh::onCoarse(const SurfacePoint& fine) const {
    return {parents_[fine.triangle], parts_[fineParts_[fine.triangle]].corners * fine.weights};
}

SurfacePoint RefinedMesh::onFine(const SurfacePoint& coarse) const {
    const Part* part = &parts_[coarse.triangle];
    Eigen::Vector3f weights = coarse.weights;
    while (part->count > 0) {
        // Takes the part in which the place lies deepest, because rounding may put it on a border.
        const Part* best = nullptr;
        for (std::uint32_t k = part->first; k < part->first + part->count; ++k) {
            const Eigen::Vector3f inside = parts_[k].corners.inverse() * coarse.weights;
            if (!best || inside.minCoeff() > weights.minCoeff()) {
                best = &parts_[k];
                weights = inside;
            }
        }
        part = best;
    }
    weights = weights.cwiseMax(0.0f);
    return {part->first, weights / weights.sum()};
}

float SurfaceField::atFine(const SurfacePoint& fine) const {
    const auto& [a, b, c] = mesh->mesh().triangles[fine.triangle];
    return fine.weights[0] * values[a] + fine.weights[1] * values[b] + fine.weights[2] * values[c];
}

} // namespace dipwright

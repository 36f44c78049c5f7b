#include "geometry/SurfaceDistance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace dipwright {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();

// The triangles around each position.
class TrianglesAround {
public:
    explicit TrianglesAround(const TriangleMesh& mesh) : first_(mesh.positions.size() + 1) {
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t corner : triangle) {
                ++first_[corner + 1];
            }
        }
        for (std::size_t position = 0; position + 1 < first_.size(); ++position) {
            first_[position + 1] += first_[position];
        }
        triangles_.resize(first_.back());
        std::vector<std::uint32_t> filled(first_.begin(), first_.end() - 1);
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            for (const std::uint32_t corner : mesh.triangles[triangle]) {
                triangles_[filled[corner]++] = triangle;
            }
        }
    }
    template <typename Visit>
    void forEach(std::uint32_t position, const Visit& visit) const {
        for (std::uint32_t k = first_[position]; k < first_[position + 1]; ++k) {
            visit(triangles_[k]);
        }
    }

private:
    std::vector<std::uint32_t> first_, triangles_;
};

// Returns the distance at the origin for a front that reaches `a` at distance `atA` and `b` at
// `atB`.
float arrival(const Eigen::Vector3f& a, float atA, const Eigen::Vector3f& b, float atB) {
    const float along = std::min(atA + a.norm(), atB + b.norm());
    if (atA == far || atB == far) {
        return along;
    }
    // The front is straight: with its unit direction n in the triangle's plane, n·a = atA − t and
    // n·b = atB − t; |n| = 1 is a quadratic equation for the distance t at the origin.
    Eigen::Matrix2f inner;
    inner << a.squaredNorm(), a.dot(b), a.dot(b), b.squaredNorm();
    const float determinant = inner.determinant();
    if (!(determinant > 0)) {
        return along;
    }
    Eigen::Matrix2f inverse;
    inverse << inner(1, 1), -inner(0, 1), -inner(1, 0), inner(0, 0);
    inverse /= determinant;
    const Eigen::Vector2f known(atA, atB);
    const Eigen::Vector2f ones = Eigen::Vector2f::Ones();
    const float p = ones.dot(inverse * ones);
    const float q = ones.dot(inverse * known);
    const float r = known.dot(inverse * known) - 1;
    const float root = q * q - p * r;
    if (!(root >= 0)) {
        return along;
    }
    const float t = (q + std::sqrt(root)) / p;
    // Valid only if the front came through the triangle and not past one of its sides.
    const Eigen::Vector2f from = inverse * (known - t * ones);
    return from.maxCoeff() < 0 ? std::min(t, along) : along;
}

} // namespace

std::vector<float> surfaceDistance(const TriangleMesh& mesh, std::vector<float> begin, float limit,
                                   const UnfoldedTriangles& measured) {
    const TrianglesAround around(mesh);
    std::vector<float> distance = std::move(begin);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (std::uint32_t position = 0; position < distance.size(); ++position) {
        if (distance[position] <= limit) {
            front.emplace(distance[position], position);
        }
    }
    std::vector<std::uint8_t> done(distance.size());
    while (!front.empty()) {
        const auto [at, position] = front.top();
        front.pop();
        if (done[position] != 0 || at > distance[position]) {
            continue;
        }
        done[position] = 1;
        around.forEach(position, [&](std::uint32_t triangle) {
            const auto& corners = mesh.triangles[triangle];
            const std::array<Eigen::Vector3f, 3> places =
                measured.empty() ? cornersOf(mesh, triangle) : measured[triangle];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t c = corners[k];
                if (done[c] != 0) {
                    continue;
                }
                const std::size_t a = (k + 1) % 3;
                const std::size_t b = (k + 2) % 3;
                const float reached = arrival(places[a] - places[k], distance[corners[a]],
                                              places[b] - places[k], distance[corners[b]]);
                if (reached < distance[c] && reached <= limit) {
                    distance[c] = reached;
                    front.emplace(reached, c);
                }
            }
        });
    }
    for (float& value : distance) {
        value = value <= limit ? value : far;
    }
    return distance;
}

} // namespace dipwright

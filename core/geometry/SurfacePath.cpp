#include "geometry/SurfacePath.h"

#include "geometry/SurfaceDistance.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace dipwright {
namespace {

constexpr int samples = 16; // places on an edge at which the line may cross it
constexpr int rounds = 60;  // of shortening
constexpr float least = 1e-6f;
constexpr float settled = 1e-4f;        // mm
constexpr double gain = 1e-4;           // mm
constexpr std::size_t mostAround = 100; // triangles around a corner
constexpr std::uint32_t noCorner = 0xffffffffu;

// A place on an edge of the mesh.
struct Crossing {
    std::uint32_t a = 0, b = 0; // the edge's ends
    float share = 0;            // 0: at a, 1: at b
    std::uint32_t edge = noEdge;
};

class Tracer {
public:
    Tracer(const TriangleMesh& mesh, const SurfacePoint& from, const CancelToken& cancel)
        : mesh_(mesh), cancel_(cancel), from_(from), start_(position(mesh, from)),
          opposite_(oppositeEdges(mesh)) {
        std::vector<float> begin(mesh.positions.size(), std::numeric_limits<float>::infinity());
        for (const std::uint32_t corner : mesh.triangles[from.triangle]) {
            begin[corner] = (mesh.positions[corner] - start_).norm();
        }
        distance_ = surfaceDistance(mesh, std::move(begin));
    }

    // Goes from `to` towards the start, through each triangle at most once. Returns the edges that
    // the line crosses; nothing if the start is not reached.
    std::optional<std::vector<Crossing>> crossings(const SurfacePoint& to) const {
        std::vector<Crossing> crossed;
        std::vector<std::uint8_t> visited(mesh_.triangles.size(), 0);
        Eigen::Vector3f place = position(mesh_, to);
        std::uint32_t triangle = to.triangle;
        while (triangle != from_.triangle) {
            cancel_.throwIfCancelled();
            visited[triangle] = 1;
            const Crossing next = nearest(triangle, place, visited);
            if (next.edge == noEdge) {
                return std::nullopt;
            }
            crossed.push_back(next);
            place = at(next);
            triangle = opposite_[next.edge] / 3;
        }
        return crossed;
    }

    // Moves the crossings along their edges until the line is as short as it becomes. Where that
    // leads it into a corner, it passes the corner on the other side if that is shorter.
    std::vector<Eigen::Vector3f> shortened(std::vector<Crossing> crossed,
                                           const Eigen::Vector3f& end) const {
        std::vector<Eigen::Vector3f> line = relaxed(crossed, end);
        for (std::size_t place = 0; place < crossed.size();) {
            const auto [corner, last] = cornerAt(crossed, line, place);
            const auto other =
                corner == noCorner ? std::nullopt : otherSide(crossed, place, last, corner);
            const auto turned = other ? relaxed(*other, end) : std::vector<Eigen::Vector3f>();
            if (other && lengthOf(turned) < lengthOf(line) - gain) {
                crossed = *other;
                line = turned;
                place -=
                    std::min<std::size_t>(place, 2); // corners before it may now be passed, too
            } else {
                ++place;
            }
        }
        std::reverse(line.begin(), line.end());
        return line;
    }

private:
    std::vector<Eigen::Vector3f> relaxed(const std::vector<Crossing>& crossed,
                                         const Eigen::Vector3f& end) const {
        std::vector<Eigen::Vector3f> line{end};
        for (const Crossing& crossing : crossed) {
            line.push_back(at(crossing));
        }
        line.push_back(start_);
        for (int round = 0; round < rounds; ++round) {
            cancel_.throwIfCancelled();
            float moved = 0;
            for (std::size_t place = 1; place + 1 < line.size(); ++place) {
                const Eigen::Vector3f before = line[place];
                line[place] = between(crossed[place - 1], line[place - 1], line[place + 1]);
                moved = std::max(moved, (line[place] - before).norm());
            }
            if (moved < settled) {
                break;
            }
        }
        return line;
    }

    // Returns the corner in which the line lies at the crossing `first`, and the last crossing that
    // lies there, too; noCorner: it lies in none.
    std::pair<std::uint32_t, std::size_t> cornerAt(const std::vector<Crossing>& crossed,
                                                   const std::vector<Eigen::Vector3f>& line,
                                                   std::size_t first) const {
        for (const std::uint32_t corner : {crossed[first].a, crossed[first].b}) {
            const auto isThere = [&](std::size_t place) {
                return (crossed[place].a == corner || crossed[place].b == corner) &&
                       (line[place + 1] - mesh_.positions[corner]).norm() < 10 * settled;
            };
            if (isThere(first)) {
                std::size_t last = first;
                while (last + 1 < crossed.size() && isThere(last + 1)) {
                    ++last;
                }
                return {corner, last};
            }
        }
        return {noCorner, first};
    }

    // Returns the crossings of a line that passes a corner on the other side than the crossings
    // `first` to `last`; nothing if the surface ends there.
    std::optional<std::vector<Crossing>> otherSide(const std::vector<Crossing>& crossed,
                                                   std::size_t first, std::size_t last,
                                                   std::uint32_t corner) const {
        std::vector<Crossing> around(crossed.begin(), crossed.begin() + std::ptrdiff_t(first));
        const std::uint32_t end = opposite_[crossed[last].edge] / 3;
        std::uint32_t entered = crossed[first].edge;
        for (std::size_t step = 0; step < mostAround; ++step) {
            const std::uint32_t triangle = entered / 3;
            std::uint32_t edge = noEdge; // the other edge at the corner
            for (std::uint32_t side = 0; side < 3; ++side) {
                const auto& corners = mesh_.triangles[triangle];
                const bool touches = corners[side] == corner || corners[(side + 1) % 3] == corner;
                if (touches && 3 * triangle + side != entered) {
                    edge = 3 * triangle + side;
                }
            }
            if (edge == noEdge || opposite_[edge] == noEdge) {
                return std::nullopt;
            }
            const auto& corners = mesh_.triangles[triangle];
            const std::uint32_t a = corners[edge % 3], b = corners[(edge % 3 + 1) % 3];
            around.push_back({a, b, a == corner ? 0.1f : 0.9f, edge});
            entered = opposite_[edge];
            if (entered / 3 == end) {
                around.insert(around.end(), crossed.begin() + std::ptrdiff_t(last) + 1,
                              crossed.end());
                return around;
            }
        }
        return std::nullopt;
    }

    Eigen::Vector3f at(const Crossing& crossing) const {
        return (1 - crossing.share) * mesh_.positions[crossing.a] +
               crossing.share * mesh_.positions[crossing.b];
    }
    float distanceAt(const Crossing& crossing) const {
        if (opposite_[crossing.edge] / 3 == from_.triangle) { // exact
            return (at(crossing) - start_).norm();
        }
        return (1 - crossing.share) * distance_[crossing.a] +
               crossing.share * distance_[crossing.b];
    }

    // Returns the place on the triangle's edges through which the start is nearest; no edge: all
    // neighbours are visited, or the start is not connected.
    Crossing nearest(std::uint32_t triangle, const Eigen::Vector3f& place,
                     const std::vector<std::uint8_t>& visited) const {
        Crossing best;
        float shortest = std::numeric_limits<float>::infinity();
        for (std::uint32_t side = 0; side < 3; ++side) {
            const std::uint32_t edge = 3 * triangle + side;
            if (opposite_[edge] == noEdge || visited[opposite_[edge] / 3]) {
                continue;
            }
            for (int sample = 0; sample < samples; ++sample) { // never at a corner
                const Crossing crossing{mesh_.triangles[triangle][side],
                                        mesh_.triangles[triangle][(side + 1) % 3],
                                        (float(sample) + 0.5f) / samples, edge};
                const float whole = (at(crossing) - place).norm() + distanceAt(crossing);
                if (whole < shortest) {
                    shortest = whole;
                    best = crossing;
                }
            }
        }
        return best;
    }

    // Returns the point of a crossing's edge over which the way between two places is shortest: the
    // places are turned about the edge into one plane, on its two sides.
    Eigen::Vector3f between(const Crossing& crossing, const Eigen::Vector3f& from,
                            const Eigen::Vector3f& to) const {
        const Eigen::Vector3f &a = mesh_.positions[crossing.a], &b = mesh_.positions[crossing.b];
        const float length = (b - a).norm();
        if (length < least) {
            return a;
        }
        const Eigen::Vector3f along = (b - a) / length;
        const auto offEdge = [&](const Eigen::Vector3f& place) {
            return (place - a - along.dot(place - a) * along).norm();
        };
        const float before = offEdge(from), after = offEdge(to), sum = before + after;
        const float share = sum < least ? 0.5f : before / sum;
        const float place = (1 - share) * along.dot(from - a) + share * along.dot(to - a);
        return a + std::clamp(place, 0.0f, length) * along;
    }

    const TriangleMesh& mesh_;
    CancelToken cancel_;
    SurfacePoint from_;
    Eigen::Vector3f start_;
    std::vector<std::uint32_t> opposite_;
    std::vector<float> distance_; // from the start, for each position
};

} // namespace

std::vector<Eigen::Vector3f> surfacePath(const TriangleMesh& mesh, const SurfacePoint& from,
                                         const SurfacePoint& to, const CancelToken& cancel) {
    const Tracer tracer(mesh, from, cancel);
    const auto crossed = tracer.crossings(to);
    return crossed ? tracer.shortened(*crossed, position(mesh, to))
                   : std::vector<Eigen::Vector3f>();
}

double lengthOf(const std::vector<Eigen::Vector3f>& line) {
    double length = 0;
    for (std::size_t point = 1; point < line.size(); ++point) {
        length += double((line[point] - line[point - 1]).norm());
    }
    return length;
}

} // namespace dipwright

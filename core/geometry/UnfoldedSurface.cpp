#include "geometry/UnfoldedSurface.h"

#include "base/Units.h"
#include "geometry/OpenSeams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace dipwright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double edgesInRadius = 40; // edges of the refined mesh within the radius
// The start place has at least this weight of each corner of its triangle, because directions are
// undefined if it lies on a corner.
constexpr double leastWeight = 1e-3;
// a path counts as shorter if its length is below this share of the other's
constexpr double shorterShare = 1 - 1e-9;
constexpr double mostDistortion = 2; // a triangle distorted by more than this factor is torn

double segmentDistance(const Eigen::Vector3d& place, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((place - from).dot(along) / length, 0.0, 1.0) : 0;
    return (from + share * along - place).norm();
}

RefinedMesh refinedRound(const TriangleMesh& mesh, const Eigen::Vector3d& place, double radius) {
    const double longest = radius / edgesInRadius;
    return {mesh, RefinedMesh::TooLong([=](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                const Eigen::Vector3d from = a.cast<double>(), to = b.cast<double>();
                return (to - from).norm() > longest &&
                       segmentDistance(place, from, to) <= radius + longest;
            })};
}

double turned(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

// Returns the apex to the left of the line from `from` to `to`, at the given distances from both.
Eigen::Vector2d apexOf(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double fromEnd,
                       double toEnd) {
    const Eigen::Vector2d base = to - from;
    const double length = std::max(base.norm(), 1e-12);
    const double along = (fromEnd * fromEnd - toEnd * toEnd + length * length) / (2 * length);
    const double across = std::sqrt(std::max(0.0, fromEnd * fromEnd - along * along));
    const Eigen::Vector2d unit = base / length;
    return from + along * unit + across * Eigen::Vector2d(-unit.y(), unit.x());
}

// Propagates places in the plane from triangle to triangle, the nearest first.
class Spreading {
public:
    Spreading(const TriangleMesh& mesh, double limit)
        : mesh_(mesh), limit_(limit),
          places_(mesh.positions.size(), Eigen::Vector2d::Constant(infinity)),
          first_(mesh.positions.size() + 1) {
        for (const auto& corners : mesh.triangles) {
            for (const std::uint32_t corner : corners) {
                ++first_[corner + 1];
            }
        }
        for (std::size_t k = 1; k < first_.size(); ++k) {
            first_[k] += first_[k - 1];
        }
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        around_.resize(3 * mesh.triangles.size());
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            for (const std::uint32_t corner : mesh.triangles[triangle]) {
                around_[next[corner]++] = triangle;
            }
        }
    }

    void begin(std::uint32_t point, const Eigen::Vector2d& place) { take(point, place); }

    void spread() {
        while (!open_.empty()) {
            const auto [distance, point] = open_.top();
            open_.pop();
            if (distance > places_[point].norm() || distance > limit_) {
                continue; // a shorter path has been found since
            }
            for (std::uint32_t k = first_[point]; k < first_[point + 1]; ++k) {
                const auto& corners = mesh_.triangles[around_[k]];
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    reach(corners[corner], corners[(corner + 1) % 3], corners[(corner + 2) % 3]);
                }
            }
        }
    }

    const std::vector<Eigen::Vector2d>& places() const { return places_; }

private:
    double length(std::uint32_t a, std::uint32_t b) const {
        return (mesh_.positions[a].cast<double>() - mesh_.positions[b].cast<double>()).norm();
    }

    void take(std::uint32_t point, const Eigen::Vector2d& place) {
        if (place.norm() < shorterShare * places_[point].norm() ||
            !std::isfinite(places_[point].norm())) {
            places_[point] = place;
            open_.push({place.norm(), point});
        }
    }

    // Computes the place of corner c from the places of a and b. The corners (a, b, c) are
    // counterclockwise, and the path to c crosses the edge from a to b.
    void reach(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const double fromA = places_[a].norm(), fromB = places_[b].norm();
        const double base = length(a, b);
        if (!std::isfinite(fromA) || !std::isfinite(fromB) || !(base > 0)) {
            return;
        }
        const double toA = length(a, c), toB = length(b, c);
        // The edge lies on the x axis and begins at the origin. The corner is above it; the start
        // place is below.
        const double cx = (toA * toA - toB * toB + base * base) / (2 * base);
        const double cy = std::sqrt(std::max(0.0, toA * toA - cx * cx));
        const double sx = (fromA * fromA - fromB * fromB + base * base) / (2 * base);
        const double sy = -std::sqrt(std::max(0.0, fromA * fromA - sx * sx));
        const double crossing = cy > sy ? sx - (cx - sx) * sy / (cy - sy) : sx;
        if (crossing < 0 || crossing > base) { // the path bends around an end of the edge
            const bool isRoundA = fromA + toA < fromB + toB;
            const Eigen::Vector2d& end = places_[isRoundA ? a : b];
            const double distance = isRoundA ? fromA : fromB;
            if (distance > 0) {
                take(c, end * ((distance + (isRoundA ? toA : toB)) / distance));
            }
            return;
        }
        const Eigen::Vector2d source(sx, sy);
        const Eigen::Vector2d toLeft = -source;
        const Eigen::Vector2d toRight = Eigen::Vector2d(base, 0) - source;
        const Eigen::Vector2d toCorner = Eigen::Vector2d(cx, cy) - source;
        // Seen from the source, there is a counterclockwise angle from a to b. On a curved surface
        // this angle differs from the angle in the triangle's plane.
        const double whole = -turned(toLeft, toRight);
        const double part = -turned(toLeft, toCorner);
        double seen = -turned(places_[a], places_[b]);
        if (seen < -pi / 2) {
            seen += 2 * pi;
        }
        const double share = whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
        const double angle = std::atan2(places_[a].y(), places_[a].x()) - share * seen;
        take(c, toCorner.norm() * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }

    using Open = std::pair<double, std::uint32_t>;

    const TriangleMesh& mesh_;
    double limit_;
    std::vector<Eigen::Vector2d> places_;
    std::vector<std::uint32_t> first_, around_; // the triangles around each position
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

// Returns a triangle's corners in the plane. If paths from different sides reach it, its shape in
// the plane is wrong. The triangle is then laid flat next to the edge that fits best.
std::array<Eigen::Vector2d, 3> fitted(std::array<Eigen::Vector2d, 3> places,
                                      const std::array<Eigen::Vector3f, 3>& corners) {
    std::array<double, 3> lengths{}, misfits{};
    for (std::size_t k = 0; k < 3; ++k) {
        lengths[k] = double((corners[(k + 1) % 3] - corners[k]).norm());
        misfits[k] = std::abs(std::log(std::max((places[(k + 1) % 3] - places[k]).norm(), 1e-12) /
                                       std::max(lengths[k], 1e-12)));
    }
    const Eigen::Vector2d u = places[1] - places[0], v = places[2] - places[0];
    const bool isTurnedOver = u.x() * v.y() - u.y() * v.x() < 0;
    if (!isTurnedOver &&
        *std::max_element(misfits.begin(), misfits.end()) < std::log(mostDistortion)) {
        return places;
    }
    const auto best =
        std::size_t(std::min_element(misfits.begin(), misfits.end()) - misfits.begin());
    places[(best + 2) % 3] = apexOf(places[best], places[(best + 1) % 3], lengths[(best + 2) % 3],
                                    lengths[(best + 1) % 3]);
    return places;
}

} // namespace

SurfaceFrame uprightFrame(const Eigen::Vector3d& outward) {
    constexpr double straight = 0.999;
    const Eigen::Vector3d vertical = std::abs(outward.y()) < straight
                                         ? Eigen::Vector3d::UnitY()
                                         : Eigen::Vector3d(0, 0, outward.y() > 0 ? -1 : 1);
    const Eigen::Vector3d right = vertical.cross(outward).normalized();
    return {right, outward.cross(right), outward};
}

UnfoldedSurface::UnfoldedSurface(const TriangleMesh& mesh, const SurfacePoint& middle,
                                 double radius)
    : fine_(refinedRound(withClosedSeams(mesh), position(mesh, middle).cast<double>(), radius)),
      radius_(radius) {
    const TriangleMesh& fine = fine_.mesh();
    const SurfacePoint place = fine_.onFine(middle);
    const std::array<Eigen::Vector3f, 3> corners = cornersOf(fine, place.triangle);
    Eigen::Vector3d weights = place.weights.cast<double>().cwiseMax(leastWeight);
    weights /= weights.sum();
    Eigen::Vector3d source = Eigen::Vector3d::Zero(), wanted = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        source += weights[Eigen::Index(k)] * corners[k].cast<double>();
        wanted += double(place.weights[Eigen::Index(k)]) * corners[k].cast<double>();
    }
    const SurfaceFrame frame =
        uprightFrame(triangleNormal(mesh, middle.triangle).cast<double>().normalized());
    const auto flat = [&](const Eigen::Vector3d& point) {
        return Eigen::Vector2d(frame.right.dot(point - source), frame.up.dot(point - source));
    };
    Spreading spreading(fine, radius * (1 + 2 / edgesInRadius));
    for (std::size_t k = 0; k < 3; ++k) {
        spreading.begin(fine.triangles[place.triangle][k], flat(corners[k].cast<double>()));
    }
    spreading.spread();
    const Eigen::Vector2d shift = flat(wanted);
    corners_.resize(fine.triangles.size());
    for (std::uint32_t triangle = 0; triangle < fine.triangles.size(); ++triangle) {
        Corners places;
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = spreading.places()[fine.triangles[triangle][k]];
        }
        const bool isReached = std::all_of(places.begin(), places.end(),
                                           [](const auto& corner) { return corner.allFinite(); });
        corners_[triangle] = isReached ? fitted(places, cornersOf(fine, triangle)) : places;
        for (Eigen::Vector2d& corner : corners_[triangle]) {
            corner -= shift;
        }
    }
}

std::optional<Eigen::Vector2d> UnfoldedSurface::at(const SurfacePoint& place) const {
    const SurfacePoint fine = fine_.onFine(place);
    const Corners& corners = corners_[fine.triangle];
    const Eigen::Vector3d weights = fine.weights.cast<double>();
    const Eigen::Vector2d flat =
        weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    return flat.allFinite() && flat.norm() <= radius_ ? std::optional(flat) : std::nullopt;
}

std::vector<FlatPiece> UnfoldedSurface::pieces() const {
    std::vector<FlatPiece> pieces;
    for (std::size_t triangle = 0; triangle < corners_.size(); ++triangle) {
        const Corners& corners = corners_[triangle];
        const Eigen::Vector2d middle = (corners[0] + corners[1] + corners[2]) / 3;
        if (middle.allFinite() && middle.norm() <= radius_) {
            pieces.push_back({fine_.middle(triangle), middle});
        }
    }
    return pieces;
}

} // namespace dipwright

#include "marks/StrokeArea.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr std::size_t runLength = 16; // segments that share a box, for quick rejection

// Returns the part [first, last] of 0 … 1 in which a value that changes linearly from `begin` to
// `end` is not negative; first > last if there is none.
std::array<float, 2> notNegative(float begin, float end) {
    if (begin < 0 && end < 0) {
        return {1, 0};
    }
    const float zero = begin / (begin - end); // used only if the signs differ
    return {begin < 0 ? zero : 0, end < 0 ? zero : 1};
}

} // namespace

StrokeArea::StrokeArea(const BrushPath& path, Millimetres radius) : radius_(float(radius.value())) {
    for (const BrushPoint& point : path) {
        add(point);
    }
}

void StrokeArea::add(const BrushPoint& point) {
    const Eigen::Vector3f outward(float(point.outward[0]), float(point.outward[1]),
                                  float(point.outward[2]));
    const Point added{modelPlace(point.place), outward.stableNormalized()};
    if (points_.empty()) { // a single point is a segment without length
        points_.push_back(added);
        borderLength_ = 2 * float(pi) * radius_;
    }
    borderLength_ += 2 * (added.place - points_.back().place).norm();
    points_.push_back(added);
    const std::size_t segment = points_.size() - 2;
    runs_.resize(segment / runLength + 1);
    runs_.back().extend(points_[segment].place);
    runs_.back().extend(added.place);
    const Eigen::Vector3f around = Eigen::Vector3f::Constant(radius_);
    box_.extend(added.place - around);
    box_.extend(added.place + around);
}

float StrokeArea::distance(const Eigen::Vector3f& place, const Eigen::Vector3f& outward,
                           float limit) const {
    constexpr float none = std::numeric_limits<float>::infinity();
    float nearest = limit * limit; // squared
    bool isFound = false;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        if (runs_[run].squaredExteriorDistance(place) > nearest) {
            continue;
        }
        const std::size_t end = std::min((run + 1) * runLength, points_.size() - 1);
        for (std::size_t segment = run * runLength; segment < end; ++segment) {
            const Point &a = points_[segment], &b = points_[segment + 1];
            const auto [first, last] = notNegative(outward.dot(a.outward) - leastFacing,
                                                   outward.dot(b.outward) - leastFacing);
            if (first > last) {
                continue;
            }
            const Eigen::Vector3f along = b.place - a.place;
            const float length = along.squaredNorm();
            const float foot = length > 0 ? along.dot(place - a.place) / length : 0;
            const Eigen::Vector3f nearestPoint = a.place + std::clamp(foot, first, last) * along;
            if (const float here = (place - nearestPoint).squaredNorm(); here <= nearest) {
                nearest = here;
                isFound = true;
            }
        }
    }
    return isFound ? std::sqrt(nearest) : none;
}

std::vector<std::uint32_t> trianglesOf(const TriangleMesh& mesh, const StrokeArea& stroke) {
    std::vector<std::uint8_t> isMarked(mesh.triangles.size());
    parallelFor(std::size_t(0), isMarked.size(), [&](std::size_t triangle) {
        const auto& [a, b, c] = cornersOf(mesh, triangle);
        const Eigen::Vector3f middle = (a + b + c) / 3;
        isMarked[triangle] = stroke.box().contains(middle) &&
                             stroke.contains(middle, triangleNormal(mesh, triangle));
    });
    std::vector<std::uint32_t> marked;
    for (std::uint32_t triangle = 0; triangle < isMarked.size(); ++triangle) {
        if (isMarked[triangle] != 0) {
            marked.push_back(triangle);
        }
    }
    return marked;
}

} // namespace dipwright

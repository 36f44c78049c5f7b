#include "results/SeenBody.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

// Corners are moved to multiples of 1/256 of the distance between sample points. Sums of products
// are then exact, so that triangles with a common edge leave no gap.
constexpr double steps = 256;
constexpr double farthest = 1e6; // limit of coordinates, so that no product overflows
constexpr int bandRows = 32;     // rows that are drawn together

struct Corner {
    std::int64_t x, y;
};

Corner cornerOf(const ViewedPoint& point) {
    return {std::llround(std::clamp(point.x, -farthest, farthest) * steps),
            std::llround(std::clamp(point.y, -farthest, farthest) * steps)};
}

// Returns twice the area of a triangle; positive if its corners are in clockwise order on the
// picture.
std::int64_t doubledArea(const Corner& a, const Corner& b, const Corner& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Corner sampleAt(int column, int row) {
    return {std::int64_t(column) * std::int64_t(steps) + std::int64_t(steps) / 2,
            std::int64_t(row) * std::int64_t(steps) + std::int64_t(steps) / 2};
}

// Returns the first and the last of `count` sample points that lie between two coordinates, in
// steps. The first is larger than the last if there are none.
std::array<int, 2> samplesBetween(std::int64_t from, std::int64_t to, int count) {
    const double half = steps / 2;
    return {int(std::clamp(std::ceil((double(from) - half) / steps), 0.0, double(count))),
            int(std::clamp(std::floor((double(to) - half) / steps), -1.0, double(count - 1)))};
}

} // namespace

SeenBody::SeenBody(const TriangleMesh& mesh, std::vector<ViewedPoint> points, QSize size)
    : mesh_(mesh), points_(std::move(points)), size_(size),
      triangle_(std::size_t(size.width()) * std::size_t(size.height()), SurfacePoint::noTriangle),
      nearness_(triangle_.size(), -std::numeric_limits<float>::infinity()) {
    const int bands = (size.height() + bandRows - 1) / bandRows;
    std::vector<std::vector<std::uint32_t>> inBand(std::size_t(std::max(bands, 0)));
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        const auto [top, bottom] =
            std::minmax({cornerOf(points_[a]).y, cornerOf(points_[b]).y, cornerOf(points_[c]).y});
        const auto [first, last] = samplesBetween(top, bottom, size.height());
        for (int band = first / bandRows; band <= last / bandRows && first <= last; ++band) {
            inBand[std::size_t(band)].push_back(triangle);
        }
    }
    parallelFor(0, bands, [&](int band) {
        drawRows(inBand[std::size_t(band)], band * bandRows,
                 std::min((band + 1) * bandRows, size_.height()));
    });
}

void SeenBody::drawRows(const std::vector<std::uint32_t>& triangles, int begin, int end) {
    for (const std::uint32_t triangle : triangles) {
        draw(triangle, begin, end);
    }
}

void SeenBody::draw(std::uint32_t triangle, int begin, int end) {
    std::array<std::uint32_t, 3> corners = mesh_.triangles[triangle];
    Corner a = cornerOf(points_[corners[0]]), b = cornerOf(points_[corners[1]]);
    const Corner c = cornerOf(points_[corners[2]]);
    std::int64_t area = doubledArea(a, b, c);
    if (area == 0) {
        return;
    }
    if (area < 0) {
        std::swap(a, b);
        std::swap(corners[0], corners[1]);
        area = -area;
    }
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [firstRow, lastRow] = samplesBetween(top, bottom, size_.height());
    const auto [firstColumn, lastColumn] = samplesBetween(left, right, size_.width());
    const auto whole = std::int64_t(steps);
    for (int row = std::max(firstRow, begin); row <= std::min(lastRow, end - 1); ++row) {
        const Corner start = sampleAt(firstColumn, row);
        // Parts of the area opposite the corners a, b and c.
        std::int64_t partA = doubledArea(b, c, start), partB = doubledArea(c, a, start);
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const std::int64_t partC = area - partA - partB;
            if ((partA | partB | partC) >= 0) {
                const float nearness = float((double(partA) * points_[corners[0]].nearness +
                                              double(partB) * points_[corners[1]].nearness +
                                              double(partC) * points_[corners[2]].nearness) /
                                             double(area));
                const std::size_t at = index(column, row);
                if (nearness > nearness_[at]) {
                    nearness_[at] = nearness;
                    triangle_[at] = triangle;
                }
            }
            partA -= (c.y - b.y) * whole;
            partB -= (a.y - c.y) * whole;
        }
    }
}

SurfacePoint SeenBody::at(int column, int row) const {
    const std::uint32_t triangle = triangle_[index(column, row)];
    if (triangle == SurfacePoint::noTriangle) {
        return {};
    }
    const auto& corners = mesh_.triangles[triangle];
    const Corner sample = sampleAt(column, row);
    std::array<Corner, 3> places{};
    std::transform(corners.begin(), corners.end(), places.begin(),
                   [&](std::uint32_t corner) { return cornerOf(points_[corner]); });
    Eigen::Vector3d weights;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        weights[int(corner)] =
            double(doubledArea(places[(corner + 1) % 3], places[(corner + 2) % 3], sample)) *
            points_[corners[corner]].weight;
    }
    return {triangle, (weights / weights.sum()).cast<float>()};
}

} // namespace dipwright

// A regular grid of points round a body that knows which grid edges cross the surface. Private to
// this folder.
#pragma once

#include "geometry/SurfaceQuery.h"

#include <array>
#include <limits>
#include <vector>

namespace dipwright {

// The grid extends at least one cell past the body on every side. Its cells are square seen from
// above. Immutable.
class SpaceGrid {
public:
    // `query` must search `mesh`. The grid is in the coordinates of `mesh`. `resolution` is the
    // number of cells along the body's longest edge. Cells are cubes, or `height` mm high if that
    // is less. Uses all cores; deterministic.
    SpaceGrid(const TriangleMesh& mesh, const SurfaceQuery& query, int resolution,
              float height = std::numeric_limits<float>::infinity());

    std::size_t count() const {
        return std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]);
    }
    const Eigen::Vector3i& size() const { return size_; }
    Eigen::Vector3i last() const { return size_ - Eigen::Vector3i::Ones(); }
    float width() const { return spacing_.x(); }  // of a cell, mm
    float height() const { return spacing_.y(); } // of a cell, mm
    // Index difference to the next point along an axis.
    std::size_t stride(int axis) const { return stride_[std::size_t(axis)]; }
    std::size_t index(const Eigen::Vector3i& cell) const {
        return std::size_t(cell[0]) * stride_[0] + std::size_t(cell[1]) * stride_[1] +
               std::size_t(cell[2]) * stride_[2];
    }
    Eigen::Vector3f position(const Eigen::Vector3i& cell) const {
        return origin_ + spacing_.cwiseProduct(cell.cast<float>());
    }
    // Returns the first corner of the cell that contains a place; of the nearest cell if it is
    // outside the grid.
    Eigen::Vector3i cellOf(const Eigen::Vector3f& place) const {
        const Eigen::Vector3i cell =
            (place - origin_).cwiseQuotient(spacing_).array().floor().cast<int>().matrix();
        return cell.cwiseMax(0).cwiseMin(size_ - Eigen::Vector3i::Constant(2));
    }
    // Returns the offset of one of a cell's eight corners from the first corner.
    static Eigen::Vector3i corner(int number) { return {number & 1, number >> 1 & 1, number >> 2}; }
    // Whether no edge of the cell crosses the surface.
    bool isClear(const Eigen::Vector3i& cell) const {
        for (int number = 0; number < 7; ++number) {
            for (int axis = 0; axis < 3; ++axis) {
                const Eigen::Vector3i from = corner(number);
                if (from[axis] == 0 && isCrossed(index(cell + from), axis)) {
                    return false;
                }
            }
        }
        return true;
    }
    // Calls visit(index of the first point, y, z) for all rows along X, in the order of y, then z.
    template <typename Visit>
    void forEachRow(const Visit& visit) const {
        std::size_t first = 0;
        for (int y = 0; y < size_[1]; ++y) {
            for (int z = 0; z < size_[2]; ++z, first += std::size_t(size_[0])) {
                visit(first, y, z);
            }
        }
    }
    // Calls visit(index, cell) for all points, in the order of y, then z, then x.
    template <typename Visit>
    void forEachPoint(const Visit& visit) const {
        forEachRow([&](std::size_t point, int y, int z) {
            for (Eigen::Vector3i cell(0, y, z); cell[0] < size_[0]; ++cell[0]) {
                visit(point++, cell);
            }
        });
    }
    bool isOnBorder(const Eigen::Vector3i& cell) const {
        return (cell.array() == 0).any() || (cell.array() == size_.array() - 1).any();
    }
    // Whether the grid edge from a point to the next point along an axis crosses the surface.
    bool isCrossed(std::size_t index, int axis) const {
        return crossed_[std::size_t(axis)][index] != 0;
    }
    // Calls visit(neighbour) for the points at the ends of a point's grid edges that do not cross
    // the surface. Stepping past the grid's end from a border point wraps round to another border
    // point. That is harmless, since all border points are open.
    template <typename Visit>
    void forEachConnected(std::uint32_t point, const Visit& visit) const {
        for (int axis = 0; axis < 3; ++axis) {
            const auto next = std::uint32_t(stride(axis));
            if (point + next < count() && !isCrossed(point, axis)) {
                visit(point + next);
            }
            if (point >= next && !isCrossed(point - next, axis)) {
                visit(point - next);
            }
        }
    }
    // Returns the ways of the points from `index` on to the grid's border along grid edges that do
    // not cross the surface, as bits: wayAlong(axis) and wayAgainst(axis) if the way is straight,
    // and bentWay. Border points have all straight ways. Without any bit, a point is inside the
    // body or in a closed void.
    const std::uint8_t* freeWays(std::size_t index) const { return &freeWays_[index]; }
    static std::uint8_t wayAlong(int axis) { return std::uint8_t(1 << (2 * axis)); }
    static std::uint8_t wayAgainst(int axis) { return std::uint8_t(2 << (2 * axis)); }
    static constexpr std::uint8_t bentWay = 0x40; // set only where no way is straight

private:
    void findCrossings(const SurfaceQuery& query, int axis);
    void findFreeWays();
    void findBentWays();

    Eigen::Vector3f origin_;
    Eigen::Vector3f spacing_; // mm
    Eigen::Vector3i size_;
    std::array<std::size_t, 3> stride_{};
    std::array<std::vector<std::uint8_t>, 3> crossed_;
    std::vector<std::uint8_t> freeWays_;
};

// Calls visit(distance) for every hit of a ray along an axis, up to `length`, nearest first. Hits
// closer together than `spacing` / 1000 count once.
template <typename Visit>
void forEachHit(const SurfaceQuery& query, const Eigen::Vector3f& start, int axis, float length,
                float spacing, const Visit& visit) {
    float next = 0;
    for (const float distance : query.allHits(start, Eigen::Vector3f::Unit(axis), length)) {
        if (distance >= next) {
            visit(distance);
            next = distance + 1e-3f * spacing;
        }
    }
}

} // namespace dipwright

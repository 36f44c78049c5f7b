#include "dip/TrappedAir.h"

#include "dip/TrianglePieces.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {

namespace {

// Points in space on a regular grid, one cell wider than the body on every side, and for each axis
// which steps to the next point go through the body's surface.
class SpaceGrid {
public:
    SpaceGrid(const TriangleMesh& mesh, const SurfaceQuery& query, int resolution) {
        const BoundingBox box = boundingBox(mesh);
        spacing_ = box.sizes().maxCoeff() / float(resolution);
        origin_ = box.min() - Eigen::Vector3f::Constant(spacing_);
        for (int axis = 0; axis < 3; ++axis) {
            size_[axis] = int(std::ceil(box.sizes()[axis] / spacing_)) + 3;
        }
        for (int axis = 0; axis < 3; ++axis) {
            crossed_[std::size_t(axis)].assign(count(), 0);
            findCrossings(query, axis);
        }
    }

    std::size_t count() const {
        return std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]);
    }
    const Eigen::Vector3i& size() const { return size_; }
    float spacing() const { return spacing_; }
    std::size_t index(const Eigen::Vector3i& cell) const {
        return (std::size_t(cell[1]) * std::size_t(size_[2]) + std::size_t(cell[2])) *
                   std::size_t(size_[0]) +
               std::size_t(cell[0]);
    }
    Eigen::Vector3f position(const Eigen::Vector3i& cell) const {
        return origin_ + spacing_ * cell.cast<float>();
    }
    Eigen::Vector3i nearestCell(const Eigen::Vector3f& place) const {
        const Eigen::Vector3i cell =
            ((place - origin_) / spacing_).array().round().cast<int>().matrix();
        return cell.cwiseMax(0).cwiseMin(size_ - Eigen::Vector3i::Ones());
    }
    bool isCrossed(const Eigen::Vector3i& cell, int axis) const {
        return crossed_[std::size_t(axis)][index(cell)] != 0;
    }

private:
    // Goes along every grid line of the axis from hit to hit.
    void findCrossings(const SurfaceQuery& query, int axis) {
        const int second = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        const float length = spacing_ * float(size_[axis] - 1);
        parallelFor(0, size_[second], [&](int along) {
            for (int across = 0; across < size_[third]; ++across) {
                Eigen::Vector3i cell = Eigen::Vector3i::Zero();
                cell[second] = along;
                cell[third] = across;
                const Eigen::Vector3f start = position(cell);
                float done = 0;
                while (done < length) {
                    const Eigen::Vector3f from = start + done * Eigen::Vector3f::Unit(axis);
                    const RayHit hit = query.hit(from, Eigen::Vector3f::Unit(axis), length - done);
                    if (!hit.point.isValid()) {
                        break;
                    }
                    done += hit.distance;
                    cell[axis] = std::min(int(done / spacing_), size_[axis] - 1);
                    crossed_[std::size_t(axis)][index(cell)] = 1;
                    done += 1e-3f * spacing_;
                }
            }
        });
    }

    Eigen::Vector3f origin_;
    float spacing_ = 0;
    Eigen::Vector3i size_;
    std::array<std::vector<std::uint8_t>, 3> crossed_;
};

class UnionFind {
public:
    explicit UnionFind(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t root(std::uint32_t item) {
        while (parent_[item] != item) {
            parent_[item] = parent_[parent_[item]];
            item = parent_[item];
        }
        return item;
    }
    void join(std::uint32_t one, std::uint32_t other) {
        one = root(one);
        other = root(other);
        parent_[std::max(one, other)] = std::min(one, other);
    }

private:
    std::vector<std::uint32_t> parent_;
};

// For every grid point whether it is in open air at the moment at which the water comes to its
// height. The water's levels are gone through from the top down: what is open stays open for all
// levels below.
std::vector<std::uint8_t> openAir(const SpaceGrid& grid) {
    const Eigen::Vector3i& size = grid.size();
    const auto outside = std::uint32_t(grid.count());
    UnionFind air(grid.count() + 1);
    std::vector<std::uint8_t> open(grid.count(), 0);
    for (int y = size[1] - 1; y >= 0; --y) {
        for (int z = 0; z < size[2]; ++z) {
            for (int x = 0; x < size[0]; ++x) {
                const Eigen::Vector3i cell(x, y, z);
                const auto here = std::uint32_t(grid.index(cell));
                if (x == 0 || z == 0 || y == size[1] - 1) {
                    air.join(here, outside);
                }
                for (int axis = 0; axis < 3; ++axis) {
                    const Eigen::Vector3i next = cell + Eigen::Vector3i::Unit(axis);
                    if (next[axis] < size[axis] && !grid.isCrossed(cell, axis)) {
                        air.join(here, std::uint32_t(grid.index(next)));
                    }
                }
            }
        }
        const std::uint32_t openRoot = air.root(outside);
        for (int z = 0; z < size[2]; ++z) {
            for (int x = 0; x < size[0]; ++x) {
                const auto here = std::uint32_t(grid.index({x, y, z}));
                open[here] = air.root(here) == openRoot;
            }
        }
    }
    return open;
}

} // namespace

TrappedAir trappedAir(const PosedBody& body, int resolution) {
    const TriangleMesh& mesh = body.mesh;
    const SpaceGrid grid(mesh, body.query, resolution);
    const std::vector<std::uint8_t> open = openAir(grid);
    const double bottom = boundingBox(mesh).min().y();
    TrappedAir trapped;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const double area = triangleArea(mesh, triangle);
        const int pieces = 1 + int(std::sqrt(area) / grid.spacing());
        const Eigen::Vector3f offset = grid.spacing() * triangleNormal(mesh, triangle);
        int caught = 0;
        forEachPiece(std::uint32_t(triangle), pieces, [&](const SurfacePoint& middle) {
            const Eigen::Vector3f place = position(mesh, middle);
            if (!open[grid.index(grid.nearestCell(place + offset))]) {
                const double height = double(place.y()) - bottom;
                trapped.height = std::min(trapped.height.value_or(height), height);
                ++caught;
            }
        });
        trapped.area += area * caught / (pieces * pieces);
    }
    return trapped;
}

} // namespace dipwright

#include "dip/AirSweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {

namespace {

// Chambers of air, as disjoint sets of grid points that merge while the water level falls. A
// chamber that has opened is no longer merged, so its set of points stays known.
class Chambers {
public:
    explicit Chambers(std::size_t count) : parent_(count), opensIn_(count, AirSweep::never) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t root(std::uint32_t item) {
        while (parent_[item] != item) {
            parent_[item] = parent_[parent_[item]];
            item = parent_[item];
        }
        return item;
    }
    void open(std::uint32_t item, int layer) {
        int& opens = opensIn_[root(item)];
        opens = std::min(opens, layer);
    }
    void join(std::uint32_t one, std::uint32_t other, int layer) {
        one = root(one);
        other = root(other);
        const bool oneIsOpen = opensIn_[one] != AirSweep::never;
        const bool otherIsOpen = opensIn_[other] != AirSweep::never;
        if (oneIsOpen || otherIsOpen) {
            open(oneIsOpen ? other : one, layer);
        } else {
            parent_[std::max(one, other)] = std::min(one, other);
        }
    }
    int opensIn(std::uint32_t item) { return opensIn_[root(item)]; }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<int> opensIn_; // per root of a set: the layer in which the chamber opens
};

// Returns the points in the order of their layers, by counting sort.
std::vector<std::uint32_t> fromTheTop(const std::vector<int>& layer, int layers) {
    std::vector<std::uint32_t> next(std::size_t(layers) + 1, 0);
    for (const int each : layer) {
        ++next[std::size_t(each) + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::uint32_t> order(layer.size());
    for (std::uint32_t point = 0; point < layer.size(); ++point) {
        order[next[std::size_t(layer[point])]++] = point;
    }
    return order;
}

} // namespace

AirSweep sweepAir(const SpaceGrid& grid, const Eigen::Vector3f& up) {
    AirSweep sweep;
    const Eigen::Vector3i& size = grid.size();
    const Eigen::Vector3f last = (size - Eigen::Vector3i::Ones()).cast<float>();
    const float highest = up.cwiseMax(0).dot(last); // in cells
    const float lowest = up.cwiseMin(0).dot(last);
    const int layers = int(std::lround(highest - lowest)) + 1;
    sweep.layer.resize(grid.count());
    std::vector<std::uint8_t> isOnBorder(grid.count());
    grid.forEachPoint([&](std::size_t point, const Eigen::Vector3i& cell) {
        const int below = int(std::lround(highest - up.dot(cell.cast<float>())));
        sweep.layer[point] = std::clamp(below, 0, layers - 1);
        isOnBorder[point] = grid.isOnBorder(cell) ? 1 : 0;
    });
    Chambers chambers(grid.count());
    for (const std::uint32_t point : fromTheTop(sweep.layer, layers)) {
        const int layer = sweep.layer[point];
        if (isOnBorder[point] != 0) {
            chambers.open(point, layer); // points on the grid's border are outside the body
        }
        // Stepping past the grid's end from a border point wraps round to another border point.
        // That is harmless, since all border points are open.
        for (int axis = 0; axis < 3; ++axis) {
            const auto stride = std::uint32_t(grid.stride(axis));
            const bool hasNext = point + stride < grid.count() && !grid.isCrossed(point, axis);
            if (hasNext && sweep.layer[point + stride] <= layer) {
                chambers.join(point, point + stride, layer);
            }
            const bool hasBefore = point >= stride && !grid.isCrossed(point - stride, axis);
            if (hasBefore && sweep.layer[point - stride] <= layer) {
                chambers.join(point, point - stride, layer);
            }
        }
    }
    sweep.opensIn.resize(grid.count());
    sweep.chamber.resize(grid.count());
    for (std::uint32_t point = 0; point < grid.count(); ++point) {
        sweep.opensIn[point] = chambers.opensIn(point);
        sweep.chamber[point] = chambers.root(point);
    }
    return sweep;
}

std::map<std::uint32_t, AirChamber> trappedChambers(const AirSweep& sweep) {
    std::map<std::uint32_t, AirChamber> chambers;
    for (std::size_t point = 0; point < sweep.layer.size(); ++point) {
        if (sweep.isTrapped(point)) {
            AirChamber& chamber = chambers[sweep.chamber[point]];
            ++chamber.points;
            chamber.top = std::min(chamber.top, sweep.layer[point]);
            chamber.opensIn = sweep.opensIn[point];
        }
    }
    return chambers;
}

} // namespace dipwright

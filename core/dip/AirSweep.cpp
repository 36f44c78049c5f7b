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
std::vector<std::uint32_t> fromTheTop(const std::vector<std::uint32_t>& points,
                                      const std::vector<int>& layer, int layers) {
    std::vector<std::uint32_t> next(std::size_t(layers) + 1, 0);
    for (const std::uint32_t point : points) {
        ++next[std::size_t(layer[point]) + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::uint32_t> order(points.size());
    for (const std::uint32_t point : points) {
        order[next[std::size_t(layer[point])]++] = point;
    }
    return order;
}

// Returns the ways along grid edges that do not go down.
std::uint8_t waysUp(const Eigen::Vector3f& up) {
    int ways = 0;
    for (int axis = 0; axis < 3; ++axis) {
        ways |= up[axis] >= 0 ? SpaceGrid::wayAlong(axis) : 0;
        ways |= up[axis] <= 0 ? SpaceGrid::wayAgainst(axis) : 0;
    }
    return std::uint8_t(ways);
}

// Returns the points and those connected with them by a grid edge, each once.
std::vector<std::uint32_t> withConnected(const SpaceGrid& grid, std::vector<std::uint32_t> points) {
    std::vector<std::uint8_t> isTaken(grid.count(), 0);
    for (const std::uint32_t point : points) {
        isTaken[point] = 1;
    }
    for (std::size_t number = 0, count = points.size(); number < count; ++number) {
        grid.forEachConnected(points[number], [&](std::uint32_t other) {
            if (isTaken[other] == 0) {
                isTaken[other] = 1;
                points.push_back(other);
            }
        });
    }
    return points;
}

} // namespace

// Most points have a straight way up to the border, so that their air opens in their own layer.
// Points inside the body have no way to the border at all. Only the others are swept.
AirSweep sweepAir(const SpaceGrid& grid, const Eigen::Vector3f& up) {
    AirSweep sweep;
    const Eigen::Vector3f last = grid.last().cast<float>();
    const float highest = up.cwiseMax(0).dot(last); // in cells
    const float lowest = up.cwiseMin(0).dot(last);
    const int layers = int(std::lround(highest - lowest)) + 1;
    sweep.layer.resize(grid.count());
    sweep.opensIn.resize(grid.count());
    const std::uint8_t upwards = waysUp(up);
    std::vector<std::uint32_t> enclosed;
    grid.forEachRow([&](std::size_t first, int y, int z) {
        const float across = up.y() * float(y) + up.z() * float(z);
        int* const layer = &sweep.layer[first];
        int* const opensIn = &sweep.opensIn[first];
        const std::uint8_t* const ways = grid.freeWays(first);
        for (int x = 0; x < grid.size()[0]; ++x) {
            const int below = int(highest - (up.x() * float(x) + across) + 0.5F);
            layer[x] = std::min(std::max(below, 0), layers - 1);
            opensIn[x] = (ways[x] & upwards) == 0 ? AirSweep::never : layer[x];
        }
        for (int x = 0; x < grid.size()[0]; ++x) {
            if (opensIn[x] == AirSweep::never && ways[x] != 0) {
                enclosed.push_back(std::uint32_t(first) + std::uint32_t(x));
            }
        }
    });
    sweep.chamber.resize(grid.count());
    std::iota(sweep.chamber.begin(), sweep.chamber.end(), 0u);
    Chambers chambers(grid.count());
    const std::vector<std::uint32_t> swept =
        fromTheTop(withConnected(grid, std::move(enclosed)), sweep.layer, layers);
    for (const std::uint32_t point : swept) {
        const int layer = sweep.layer[point];
        if (sweep.opensIn[point] != AirSweep::never) {
            chambers.open(point, layer);
        }
        grid.forEachConnected(point, [&](std::uint32_t other) {
            if (sweep.layer[other] <= layer) {
                chambers.join(point, other, layer);
            }
        });
    }
    for (const std::uint32_t point : swept) {
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

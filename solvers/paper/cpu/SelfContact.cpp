#include "paper/cpu/SelfContact.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace dipwright::cpu {

namespace {

// Points up to this factor farther apart than the kept distance are candidates, as they may touch
// within one step.
constexpr float reachFactor = 1.5f;

using Cell = std::array<std::int32_t, 3>;

// Groups points by their cell in space. Different cells may share a slot, so callers must check the
// distance.
class SpatialHash {
public:
    SpatialHash(const std::vector<numerics::Vector3<float>>& positions, float cellSize)
        : inverseCellSize_(1 / cellSize), mask_(std::bit_ceil(2 * positions.size()) - 1),
          starts_(mask_ + 2), points_(positions.size()) {
        for (const auto& position : positions) {
            ++starts_[slot(cell(position)) + 1];
        }
        for (std::size_t i = 1; i < starts_.size(); ++i) {
            starts_[i] += starts_[i - 1];
        }
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::size_t point = 0; point < positions.size(); ++point) {
            points_[next[slot(cell(positions[point]))]++] = std::uint32_t(point);
        }
    }

    // Calls visit(point) for all points in the cells around `position`, and possibly for other
    // points.
    template <typename Visit>
    void around(const numerics::Vector3<float>& position, const Visit& visit) const {
        std::array<std::size_t, 27> slots{};
        std::size_t count = 0;
        const Cell centre = cell(position);
        for (int i = 0; i < 27; ++i) {
            slots[count++] =
                slot({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
        }
        std::sort(slots.begin(), slots.end());
        const auto end = std::unique(slots.begin(), slots.end());
        for (auto it = slots.begin(); it != end; ++it) {
            for (std::uint32_t i = starts_[*it]; i < starts_[*it + 1]; ++i) {
                visit(points_[i]);
            }
        }
    }

private:
    Cell cell(const numerics::Vector3<float>& position) const {
        return {std::int32_t(std::floor(position.x * inverseCellSize_)),
                std::int32_t(std::floor(position.y * inverseCellSize_)),
                std::int32_t(std::floor(position.z * inverseCellSize_))};
    }
    std::size_t slot(const Cell& cell) const {
        const std::uint32_t hash = std::uint32_t(cell[0]) * 73856093u ^
                                   std::uint32_t(cell[1]) * 19349663u ^
                                   std::uint32_t(cell[2]) * 83492791u;
        return hash & mask_;
    }

    float inverseCellSize_;
    std::size_t mask_;
    std::vector<std::uint32_t> starts_; // per slot: index of its first entry in points_
    std::vector<std::uint32_t> points_;
};

// Adds up the entries of each point, so that one entry per point is left.
std::vector<ContactPush> summedByPoint(std::vector<ContactPush> pushes) {
    std::stable_sort(pushes.begin(), pushes.end(),
                     [](const ContactPush& a, const ContactPush& b) { return a.point < b.point; });
    std::vector<ContactPush> sums;
    for (const ContactPush& push : pushes) {
        if (sums.empty() || sums.back().point != push.point) {
            sums.push_back(push);
        } else {
            sums.back().contacts += push.contacts;
            sums.back().sum = sums.back().sum + push.sum;
        }
    }
    return sums;
}

} // namespace

SelfContact::SelfContact(const solver::FilmGrid& grid)
    : grid_(grid), distance_(float(std::min(grid.spacingX(0), grid.spacingZ(0)) / 2)) {}

bool SelfContact::areGridNeighbours(std::uint32_t a, std::uint32_t b) const {
    const auto columns = std::uint32_t(grid_.columns);
    return std::abs(int(a % columns) - int(b % columns)) <= 1 &&
           std::abs(int(a / columns) - int(b / columns)) <= 1;
}

void SelfContact::find(const FilmPoints& points) {
    const float reach = distance_ * reachFactor;
    const SpatialHash hash(points.positions, reach);
    candidates_.clear();
    for (std::uint32_t a = 0; a < points.positions.size(); ++a) {
        const auto firstOfPoint = std::ptrdiff_t(candidates_.size());
        hash.around(points.positions[a], [&](std::uint32_t b) {
            const bool isMobile = points.weights[a] + points.weights[b] > 0;
            if (b > a && isMobile && !areGridNeighbours(a, b) &&
                length(points.positions[b] - points.positions[a]) < reach) {
                candidates_.emplace_back(a, b);
            }
        });
        std::sort(candidates_.begin() + firstOfPoint, candidates_.end());
    }
}

std::vector<ContactPush> SelfContact::pushes(const FilmPoints& points) const {
    std::vector<ContactPush> pushes;
    for (const auto& [a, b] : candidates_) {
        const numerics::Vector3<float> apart = points.positions[b] - points.positions[a];
        const float distance = length(apart);
        if (distance >= distance_ || distance == 0) {
            continue;
        }
        const float w1 = points.weights[a], w2 = points.weights[b];
        const float lambda = (distance - distance_) / (distance * (w1 + w2));
        if (w1 > 0) {
            pushes.push_back({a, 1, apart * (w1 * lambda)});
        }
        if (w2 > 0) {
            pushes.push_back({b, 1, apart * (-w2 * lambda)});
        }
    }
    return summedByPoint(std::move(pushes));
}

} // namespace dipwright::cpu

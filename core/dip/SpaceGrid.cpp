#include "dip/SpaceGrid.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Shift of the grid in cells. Models often have edges and faces in the middle or at the sides of
// their bounding box. A ray along them may slip between two triangles.
const Eigen::Vector3f gridShift(0.37f, 0.29f, 0.43f);

// Gives a way to the points of a span if the points next to them have it, except over crossed
// edges.
void passOn(const std::uint8_t* from, std::uint8_t* to, const std::uint8_t* crossed,
            std::size_t count, std::uint8_t way) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t passes = crossed[i] == 0 ? way : 0;
        to[i] = std::uint8_t(to[i] | (from[i] & passes));
    }
}

} // namespace

SpaceGrid::SpaceGrid(const TriangleMesh& mesh, const SurfaceQuery& query, int resolution,
                     float height) {
    const BoundingBox box = boundingBox(mesh);
    spacing_.setConstant(box.sizes().maxCoeff() / float(resolution));
    spacing_.y() = std::min(spacing_.y(), height);
    origin_ = box.min() - spacing_.cwiseProduct(Eigen::Vector3f::Ones() + gridShift);
    for (int axis = 0; axis < 3; ++axis) {
        size_[axis] = int(std::ceil(box.sizes()[axis] / spacing_[axis])) + 4;
    }
    stride_ = {1, std::size_t(size_[0]) * std::size_t(size_[2]), std::size_t(size_[0])};
    for (int axis = 0; axis < 3; ++axis) {
        crossed_[std::size_t(axis)].assign(count(), 0);
        findCrossings(query, axis);
    }
    findFreeWays();
    findBentWays();
}

void SpaceGrid::findCrossings(const SurfaceQuery& query, int axis) {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    const float spacing = spacing_[axis];
    const float length = spacing * float(size_[axis] - 1);
    parallelFor(0, size_[second], [&](int along) {
        for (int across = 0; across < size_[third]; ++across) {
            Eigen::Vector3i cell = Eigen::Vector3i::Zero();
            cell[second] = along;
            cell[third] = across;
            const Eigen::Vector3f start = position(cell);
            forEachHit(query, start, axis, length, spacing, [&](float distance) {
                cell[axis] = std::min(int(distance / spacing), size_[axis] - 1);
                crossed_[std::size_t(axis)][index(cell)] = 1;
            });
        }
    });
}

void SpaceGrid::findFreeWays() {
    constexpr std::uint8_t all = 0x3f;
    freeWays_.assign(count(), all);
    forEachRow([&](std::size_t first, int y, int z) {
        if (y > 0 && y < size_[1] - 1 && z > 0 && z < size_[2] - 1) {
            std::fill_n(freeWays_.begin() + std::ptrdiff_t(first) + 1, size_[0] - 2,
                        std::uint8_t(0));
        }
    });
    // Border points have all ways, so it does not matter what they get from points that are no
    // neighbours.
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t next = stride(axis);
        const std::uint8_t* const crossed = crossed_[std::size_t(axis)].data();
        for (std::size_t first = count() - next; first > 0;) {
            first -= std::min(first, next);
            passOn(&freeWays_[first + next], &freeWays_[first], crossed + first, next,
                   wayAlong(axis));
        }
        for (std::size_t first = next; first < count(); first += next) {
            passOn(&freeWays_[first - next], &freeWays_[first], crossed + first - next, next,
                   wayAgainst(axis));
        }
    }
}

void SpaceGrid::findBentWays() {
    std::vector<std::uint32_t> ahead;
    const auto reach = [&](std::uint32_t point) {
        freeWays_[point] = bentWay;
        ahead.push_back(point);
    };
    for (std::uint32_t point = 0; point < count(); ++point) {
        if (freeWays_[point] == 0) {
            bool isOpen = false;
            forEachConnected(point, [&](std::uint32_t other) { isOpen |= freeWays_[other] != 0; });
            if (isOpen) {
                reach(point);
            }
        }
    }
    while (!ahead.empty()) {
        const std::uint32_t point = ahead.back();
        ahead.pop_back();
        forEachConnected(point, [&](std::uint32_t other) {
            if (freeWays_[other] == 0) {
                reach(other);
            }
        });
    }
}

} // namespace dipwright

#include "dip/SpaceGrid.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Shift of the grid in cells. Models often have edges and faces in the middle or at the sides of
// their bounding box. A ray along them may slip between two triangles.
const Eigen::Vector3f gridShift(0.37f, 0.29f, 0.43f);

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
    freeWays_.assign(count(), 0);
    forEachPoint([&](std::size_t point, const Eigen::Vector3i& cell) {
        freeWays_[point] = isOnBorder(cell) ? all : 0;
    });
    // Border points have all ways, so it does not matter what they get from points that are no
    // neighbours.
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t next = stride(axis);
        for (std::size_t point = count() - next; point-- > 0;) {
            freeWays_[point] |=
                freeWays_[point + next] & (isCrossed(point, axis) ? 0 : wayAlong(axis));
        }
        for (std::size_t point = next; point < count(); ++point) {
            freeWays_[point] |=
                freeWays_[point - next] & (isCrossed(point - next, axis) ? 0 : wayAgainst(axis));
        }
    }
}

} // namespace dipwright

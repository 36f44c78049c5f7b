#include "dip/AirInPoses.h"

#include "dip/AirSweep.h"
#include "parallel/ParallelFor.h"

#include <limits>
#include <map>

namespace dipwright {

namespace {

constexpr int cells = 40;
// Least depth of a chamber that counts, in layers. The layers are tilted against the grid, so a
// path along a slope goes up and down by one layer. A chamber of depth 1 may therefore be an
// artefact.
constexpr int leastDepth = 2;
constexpr int leastPoints = 8;
// In cells: distance in front of a face at which the air is looked up.
constexpr float offSurface = 0.02f;
constexpr std::uint32_t noPoint = std::numeric_limits<std::uint32_t>::max();

} // namespace

AirInPoses::AirInPoses(const TriangleMesh& model) {
    const SurfaceQuery query(model);
    const auto grid = std::make_shared<const SpaceGrid>(model, query, cells);
    before_.assign(model.triangles.size(), noPoint);
    parallelFor(std::size_t(0), before_.size(), [&](std::size_t triangle) {
        const Eigen::Vector3f place = position(model, middleOf(std::uint32_t(triangle))) +
                                      offSurface * grid->width() * triangleNormal(model, triangle);
        const Eigen::Vector3i cell = grid->cellOf(place);
        float nearest = std::numeric_limits<float>::infinity();
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3i at = cell + SpaceGrid::corner(corner);
            const Eigen::Vector3f way = grid->position(at) - place;
            if (way.norm() < nearest && !query.isHit(place, way, 1)) {
                nearest = way.norm();
                before_[triangle] = std::uint32_t(grid->index(at));
            }
        }
    });
    grid_ = grid;
}

std::vector<std::uint8_t> AirInPoses::dry(const Eigen::Vector3f& up) const {
    const AirSweep sweep = sweepAir(*grid_, up);
    const std::map<std::uint32_t, AirChamber> chambers = trappedChambers(sweep);
    std::vector<std::uint8_t> dry(before_.size(), 0);
    for (std::size_t triangle = 0; triangle < dry.size(); ++triangle) {
        const std::uint32_t point = before_[triangle];
        if (point != noPoint && sweep.isTrapped(point)) {
            const AirChamber& chamber = chambers.at(sweep.chamber[point]);
            dry[triangle] = chamber.points >= leastPoints && chamber.depth() >= leastDepth ? 1 : 0;
        }
    }
    return dry;
}

} // namespace dipwright

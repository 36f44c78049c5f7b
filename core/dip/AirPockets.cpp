#include "dip/AirPockets.h"

#include "dip/AirSweep.h"
#include "dip/BodyPath.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace dipwright {

namespace {

constexpr int halvings = 7; // number of bisection steps that find a level within a cell
// Largest number of points of a chamber that are tested. The chamber is inside the body if most of
// them are.
constexpr std::size_t triedPoints = 33;
constexpr std::size_t mostPockets = std::numeric_limits<std::uint16_t>::max();
// In cells: distance in front of a face at which the air is looked up.
constexpr float offSurface = 0.02f;

// Whether the grid resolves a chamber in all directions.
bool isDeep(const AirChamber& chamber, const SpaceGrid& grid) {
    const float height = grid.height() / grid.width();
    return height * float(chamber.depth()) >= leastPocketDepth &&
           height * float(chamber.points) >= leastPocketCells;
}

// Calls visit(point, cell) for all trapped points of the grid.
template <typename Visit>
void forEachTrapped(const SpaceGrid& grid, const AirSweep& sweep, const Visit& visit) {
    grid.forEachPoint([&](std::size_t point, const Eigen::Vector3i& cell) {
        if (sweep.isTrapped(point)) {
            visit(point, cell);
        }
    });
}

// Whether the eight neighbours of a trapped point in its layer are in the same chamber.
bool isInner(const SpaceGrid& grid, const AirSweep& sweep, std::size_t point) {
    const std::size_t row = grid.stride(2);
    for (const std::size_t middle : {point - row, point, point + row}) {
        for (const std::size_t other : {middle - 1, middle, middle + 1}) {
            if (!sweep.isTrapped(other) || sweep.chamber[other] != sweep.chamber[point]) {
                return false;
            }
        }
    }
    return true;
}

// Removes the chambers in which the grid cannot tell that air is trapped.
void eraseSmall(std::map<std::uint32_t, AirChamber>& chambers, const SpaceGrid& grid,
                const AirSweep& sweep) {
    std::erase_if(chambers,
                  [](const auto& each) { return each.second.depth() < leastPocketLayers; });
    std::map<std::uint32_t, int> inner;
    forEachTrapped(grid, sweep, [&](std::size_t point, const Eigen::Vector3i&) {
        if (chambers.contains(sweep.chamber[point])) {
            inner[sweep.chamber[point]] += isInner(grid, sweep, point) ? 1 : 0;
        }
    });
    std::erase_if(chambers, [&](const auto& each) {
        return !isDeep(each.second, grid) && inner[each.first] < leastInnerPoints;
    });
}

// Returns the trapped chambers that are large enough and outside the body. The inside of an open
// mesh is a chamber, too, and is removed here.
std::map<std::uint32_t, AirChamber> hollows(const SpaceGrid& grid, const AirSweep& sweep,
                                            const SurfaceQuery& query) {
    std::map<std::uint32_t, AirChamber> chambers = trappedChambers(sweep);
    eraseSmall(chambers, grid, sweep);
    std::map<std::uint32_t, std::vector<Eigen::Vector3f>> places;
    forEachTrapped(grid, sweep, [&](std::size_t point, const Eigen::Vector3i& cell) {
        if (chambers.contains(sweep.chamber[point])) {
            places[sweep.chamber[point]].push_back(grid.position(cell));
        }
    });
    std::erase_if(chambers, [&](const auto& each) {
        const std::vector<Eigen::Vector3f>& own = places[each.first];
        const std::size_t tried = std::min(own.size(), triedPoints);
        std::size_t inside = 0;
        for (std::size_t number = 0; number < tried; ++number) {
            inside += query.isInside(own[number * own.size() / tried]) ? 1 : 0;
        }
        return 2 * inside > tried;
    });
    return chambers;
}

// Finds the levels of pockets between two layers of the grid by bisection. It moves a test layer up
// and down between them and checks whether the air finds a way out within the test layer.
class LevelSearch {
public:
    // `lower` is the grid layer in which the pockets open, counted from below.
    LevelSearch(const SpaceGrid& grid, const AirSweep& sweep, const SurfaceQuery& query, int lower)
        : grid_(grid), sweep_(sweep), query_(query), lower_(lower),
          columns_(std::size_t(grid.size()[0]) * std::size_t(grid.size()[2])),
          ceiling_(columns_, 0) {
        forEachColumn([&](std::size_t column, const Eigen::Vector3i& cell) {
            forEachHit(query_, grid_.position(cell), 1, grid_.height(), grid_.height(),
                       [&](float height) { ceiling_[column] = height; });
        });
    }

    // Returns the level of a chamber that is open in the lower layer and closed in the layer above
    // it.
    double levelOf(std::uint32_t chamber) const {
        float free = 0, closed = grid_.height(); // heights above the lower layer
        for (int i = 0; i < halvings; ++i) {
            const float middle = (free + closed) / 2;
            (leadsOut(chamber, middle) ? free : closed) = middle;
        }
        return double(grid_.position({0, lower_, 0}).y() + closed);
    }

private:
    template <typename Visit>
    void forEachColumn(const Visit& visit) const {
        for (int z = 0; z < grid_.size()[2]; ++z) {
            for (int x = 0; x < grid_.size()[0]; ++x) {
                visit(std::size_t(z) * std::size_t(grid_.size()[0]) + std::size_t(x),
                      Eigen::Vector3i(x, lower_, z));
            }
        }
    }

    // Marks the grid edges along an axis that cross the surface. The edges are moved to the layer
    // `height` above the lower one.
    std::vector<std::uint8_t> crossings(int axis, float height) const {
        std::vector<std::uint8_t> crossed(columns_, 0);
        const auto width = std::size_t(grid_.size()[0]);
        const std::size_t stride = axis == 0 ? 1 : width;
        const float length = grid_.width() * float(grid_.size()[axis] - 1);
        parallelFor(0, grid_.size()[2 - axis], [&](int row) {
            const Eigen::Vector3i cell =
                axis == 0 ? Eigen::Vector3i(0, lower_, row) : Eigen::Vector3i(row, lower_, 0);
            const Eigen::Vector3f start = grid_.position(cell) + height * Eigen::Vector3f::UnitY();
            const std::size_t first = std::size_t(row) * (axis == 0 ? width : 1);
            forEachHit(query_, start, axis, length, grid_.width(), [&](float distance) {
                const int at = std::min(int(distance / grid_.width()), grid_.size()[axis] - 1);
                crossed[first + stride * std::size_t(at)] = 1;
            });
        });
        return crossed;
    }

    // Whether the chamber's air reaches the open within the layer `height` above the lower one.
    bool leadsOut(std::uint32_t chamber, float height) const {
        enum class Air : std::uint8_t { Unknown, Inside, Open };
        // Numbered from the top, as in AirSweep.
        const int upperLayer = grid_.size()[1] - 2 - lower_;
        std::vector<Air> air(columns_, Air::Unknown);
        std::vector<std::size_t> ahead;
        forEachColumn([&](std::size_t column, const Eigen::Vector3i& cell) {
            const std::size_t above = grid_.index(cell + Eigen::Vector3i::UnitY());
            if (grid_.isOnBorder(cell)) {
                air[column] = Air::Open;
            } else if (ceiling_[column] <= height) { // no surface between here and the layer above
                if (sweep_.opensIn[above] <= upperLayer) {
                    air[column] = Air::Open;
                } else if (sweep_.chamber[above] == chamber) {
                    air[column] = Air::Inside;
                    ahead.push_back(column);
                }
            }
        });
        const std::array<std::vector<std::uint8_t>, 2> crossed{crossings(0, height),
                                                               crossings(2, height)};
        const std::array<std::size_t, 2> strides{1, std::size_t(grid_.size()[0])};
        while (!ahead.empty()) {
            const std::size_t column = ahead.back(); // never on the border, which counts as open
            ahead.pop_back();
            for (std::size_t side = 0; side < 2; ++side) {
                for (const bool isNext : {true, false}) {
                    const std::size_t other =
                        isNext ? column + strides[side] : column - strides[side];
                    if (crossed[side][isNext ? column : other] != 0) {
                        continue;
                    }
                    if (air[other] == Air::Open) {
                        return true;
                    }
                    if (air[other] == Air::Unknown) {
                        air[other] = Air::Inside;
                        ahead.push_back(other);
                    }
                }
            }
        }
        return false;
    }

    const SpaceGrid& grid_;
    const AirSweep& sweep_;
    const SurfaceQuery& query_;
    int lower_;
    std::size_t columns_;
    // Per point of the lower layer: height of the highest surface hit between the two layers.
    std::vector<float> ceiling_;
};

// The directions of the vertical on a path, in the frame of the body's pose.
struct Verticals {
    std::vector<Eigen::Vector3f> up;
    std::vector<std::uint16_t> ofMoment; // per moment of the path: its direction
};

Verticals verticalsOf(const std::vector<PathMoment>& moments) {
    constexpr float alike = 0.9998f; // cosine of about 1°
    Verticals verticals;
    for (const PathMoment& moment : moments) {
        const Eigen::Vector3f up = moment.poseToWorld.linear().row(1).cast<float>();
        if (verticals.up.empty() || verticals.up.back().dot(up) < alike) {
            verticals.up.push_back(up);
        }
        verticals.ofMoment.push_back(std::uint16_t(verticals.up.size() - 1));
    }
    return verticals;
}

// Returns, per grid point, the direction of the vertical when the point first goes under water.
std::vector<std::uint16_t> verticalsAtTheWater(const SpaceGrid& grid,
                                               const std::vector<PathMoment>& moments,
                                               const Verticals& verticals) {
    constexpr std::uint16_t stays = std::numeric_limits<std::uint16_t>::max(); // above the water
    std::vector<std::uint16_t> found(grid.count(), stays);
    parallelFor(0, grid.size()[1], [&](int layer) {
        Eigen::Vector3i cell(0, layer, 0);
        for (cell[2] = 0; cell[2] < grid.size()[2]; ++cell[2]) {
            for (cell[0] = 0; cell[0] < grid.size()[0]; ++cell[0]) {
                const Eigen::Vector3d place = grid.position(cell).cast<double>();
                const auto under =
                    std::find_if(moments.begin(), moments.end(), [&](const PathMoment& moment) {
                        return (moment.poseToWorld * place).y() <= 0;
                    });
                if (under != moments.end()) {
                    found[grid.index(cell)] =
                        verticals.ofMoment[std::size_t(under - moments.begin())];
                }
            }
        }
    });
    return found;
}

} // namespace

int airCellsAlong(const Eigen::Vector3f& sizes, int cells) {
    const float longest = sizes.maxCoeff(), cell = mostAirCell * float(airCells) / float(cells);
    const float cube = std::cbrt(sizes.cwiseMax(longest / float(cells)).prod());
    const float most = float(cells) * longest / cube;
    return std::max(cells, int(std::min(std::ceil(longest / cell), most)));
}

AirPockets::AirPockets(const TriangleMesh& mesh, const SurfaceQuery& query, int cells) {
    const Eigen::Vector3f sizes = boundingBox(mesh).sizes();
    const float height = sizes.y() / float(airLayersPerCell * cells);
    const float least = airLayer * float(airCells) / float(cells);
    auto grid = std::make_shared<const SpaceGrid>(mesh, query, airCellsAlong(sizes, cells),
                                                  std::max(height, least));
    cell_ = grid->width();
    const AirSweep sweep = sweepAir(*grid, Eigen::Vector3f::UnitY());
    // Pocket number of each chamber that is a pocket.
    std::map<std::uint32_t, std::uint16_t> numbers;
    std::map<int, std::unique_ptr<const LevelSearch>> searches;
    for (const auto& [name, chamber] : hollows(*grid, sweep, query)) {
        if (pockets_.size() == mostPockets) {
            break;
        }
        const int lower = grid->size()[1] - 1 - chamber.opensIn;
        auto& search = searches[lower];
        if (!search) {
            search = std::make_unique<const LevelSearch>(*grid, sweep, query, lower);
        }
        pockets_.push_back({search->levelOf(name), BoundingBox()});
        numbers[name] = std::uint16_t(pockets_.size());
    }
    if (pockets_.empty()) {
        return;
    }
    pocketOf_.assign(grid->count(), 0);
    forEachTrapped(*grid, sweep, [&](std::size_t point, const Eigen::Vector3i& cell) {
        if (const auto number = numbers.find(sweep.chamber[point]); number != numbers.end()) {
            pocketOf_[point] = number->second;
            pockets_[number->second - 1u].box.extend(grid->position(cell));
        }
    });
    keep(std::move(grid));
}

void AirPockets::keep(std::shared_ptr<const SpaceGrid> grid) {
    for (AirPocket& pocket : pockets_) {
        pocket.box.min() -= Eigen::Vector3f::Constant(cell_);
        pocket.box.max() += Eigen::Vector3f::Constant(cell_);
    }
    grid_ = std::move(grid);
}

AirPockets::AirPockets(const TriangleMesh& mesh, const SurfaceQuery& query,
                       const solver::BodyPath& path, int cells) {
    auto grid = std::make_shared<const SpaceGrid>(mesh, query,
                                                  airCellsAlong(boundingBox(mesh).sizes(), cells));
    cell_ = grid->width();
    isOnPath_ = true;
    const std::vector<PathMoment> moments = momentsOf(path, 2 * double(cell_));
    const Verticals verticals = verticalsOf(moments);
    const std::vector<std::uint16_t> verticalAt = verticalsAtTheWater(*grid, moments, verticals);
    std::vector<std::uint8_t> isTrapped(grid->count(), 0);
    parallelFor(std::size_t(0), verticals.up.size(), [&](std::size_t vertical) {
        const AirSweep sweep = sweepAir(*grid, verticals.up[vertical]);
        const std::map<std::uint32_t, AirChamber> chambers = hollows(*grid, sweep, query);
        for (std::size_t point = 0; point < isTrapped.size(); ++point) {
            if (verticalAt[point] == vertical && sweep.isTrapped(point) &&
                chambers.contains(sweep.chamber[point])) {
                isTrapped[point] = 1; // each point has one vertical
            }
        }
    });
    AirPocket pocket;
    grid->forEachPoint([&](std::size_t point, const Eigen::Vector3i& cell) {
        if (isTrapped[point] != 0) {
            pocket.box.extend(grid->position(cell));
        }
    });
    if (pocket.box.isEmpty()) {
        return;
    }
    pocketOf_.assign(isTrapped.begin(), isTrapped.end()); // all belong to one pocket, number 1
    pocket.level = double(pocket.box.min().y() - cell_);
    pockets_.push_back(pocket);
    keep(std::move(grid));
}

const AirPocket* AirPockets::at(const Eigen::Vector3f& place, const SurfaceQuery& query) const {
    const bool isNear = std::any_of(pockets_.begin(), pockets_.end(), [&](const AirPocket& pocket) {
        return pocket.box.contains(place) && double(place.y()) > pocket.level;
    });
    if (!isNear) {
        return nullptr;
    }
    // A place belongs to a pocket if a straight line from it to a point of the pocket misses the
    // surface.
    const Eigen::Vector3i cell = grid_->cellOf(place);
    const auto seen = [&](const Eigen::Vector3i& point, bool isClear) -> const AirPocket* {
        const std::uint16_t number = pocketOf_[grid_->index(point)];
        if (number == 0 || double(place.y()) <= pockets_[number - 1u].level) {
            return nullptr;
        }
        const Eigen::Vector3f way = grid_->position(point) - place;
        const bool isSeen = isClear || !query.isHit(place, way, 1);
        return isSeen ? &pockets_[number - 1u] : nullptr;
    };
    const bool isClear = grid_->isClear(cell);
    if (isOnPath_) {
        return atNearestPoint(place, query);
    }
    for (int corner = 0; corner < 8; ++corner) {
        if (const AirPocket* pocket = seen(cell + SpaceGrid::corner(corner), isClear)) {
            return pocket;
        }
    }
    // Under a slanting ceiling, the nearest points of the pocket are farther away: aside where it
    // comes down to the level, and below where it is steep.
    const int lowest = -int(std::ceil(grid_->width() / grid_->height()));
    for (int up = 1; up >= lowest; --up) {
        for (int across = -1; across <= 2; ++across) {
            for (int along = -1; along <= 2; ++along) {
                const Eigen::Vector3i point =
                    (cell + Eigen::Vector3i(across, up, along)).cwiseMax(0).cwiseMin(grid_->last());
                if (const AirPocket* pocket = seen(point, false)) {
                    return pocket;
                }
            }
        }
    }
    return nullptr;
}

const AirPocket* AirPockets::atNearestPoint(const Eigen::Vector3f& place,
                                            const SurfaceQuery& query) const {
    const Eigen::Vector3i cell = grid_->cellOf(place);
    std::array<std::pair<float, Eigen::Vector3i>, 8> corners;
    for (int number = 0; number < 8; ++number) {
        const Eigen::Vector3i point = cell + SpaceGrid::corner(number);
        corners[std::size_t(number)] = {(grid_->position(point) - place).norm(), point};
    }
    std::stable_sort(corners.begin(), corners.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    for (const auto& [distance, point] : corners) {
        if (!query.isHit(place, grid_->position(point) - place, 1)) {
            const std::uint16_t number = pocketOf_[grid_->index(point)];
            return number == 0 ? nullptr : &pockets_[number - 1u];
        }
    }
    return nullptr;
}

bool AirPockets::isDry(const Eigen::Vector3f& place, const Eigen::Vector3f& outward,
                       const SurfaceQuery& query) const {
    return !isEmpty() && at(place + offSurface * cell_ * outward, query) != nullptr;
}

} // namespace dipwright

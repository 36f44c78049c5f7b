// The air that a body takes under water: where it is, and down to which height.
//
// While the water rises round a body, air at a height gets away if it can reach the open without
// ever going below that height. Where it cannot, it is cut off when the water comes to the height
// of the lowest place on its way out, the spill edge. From then on it keeps its volume: the pocket
// is all of the hollow above the spill edge's height, which is its level in the body's frame,
// however deep the body goes (docs/film-model.md, "Trapped air").
#pragma once

#include "geometry/SurfaceQuery.h"

#include <memory>
#include <vector>

namespace dipwright {

class SpaceGrid;

// Cells of the grid along the body's longest edge that air is looked for on.
inline constexpr int airCells = 96;
// What is smaller is no pocket: it must be so many cells deep, and hold so many of the grid's
// points.
inline constexpr int leastPocketDepth = 2;
inline constexpr int leastPocketPoints = 32;

struct AirPocket {
    double level = 0; // height of the water under it, mm
    BoundingBox box;  // of the grid's points in it, a cell wider on every side
};

// Of a body in the frame of its mesh, up being +Y. Hollows and ways out narrower than a cell are
// not seen, nor is the inside of an open mesh a pocket; levels are found to a hundredth of a cell.
// Immutable; any thread may ask.
class AirPockets {
public:
    // `query`: of `mesh`. All cores, deterministic.
    AirPockets(const TriangleMesh& mesh, const SurfaceQuery& query, int cells = airCells);

    bool isEmpty() const { return pockets_.empty(); }
    const std::vector<AirPocket>& all() const { return pockets_; }
    float cell() const { return cell_; } // of the grid, mm

    // The pocket that a place outside the body is in; null in the open and under water. `query`: as
    // for the constructor.
    const AirPocket* at(const Eigen::Vector3f& place, const SurfaceQuery& query) const;
    // Whether a place on the body is in a pocket, that of the face with this outward normal.
    bool isDry(const Eigen::Vector3f& place, const Eigen::Vector3f& outward,
               const SurfaceQuery& query) const;

private:
    std::vector<AirPocket> pockets_;
    std::vector<std::uint16_t> pocketOf_;   // a point of the grid each: its number from 1, or 0
    std::shared_ptr<const SpaceGrid> grid_; // null where there is no pocket
    float cell_ = 0;
};

} // namespace dipwright

// Finds the air pockets that a body takes under water, and the water level under each.
//
// While the water rises, air escapes if it can reach the open without going below its own height.
// Otherwise the water cuts it off. This happens at the spill edge, the lowest point of its best way
// out. From then on the air keeps its volume, however deep the body goes. The pocket is therefore
// all of the hollow above the height of the spill edge. That height, in the body's frame, is the
// pocket's level (docs/film-model.md, "Trapped air").
//
// On a path the body turns, so the ways out change. A place belongs to a pocket if its air is cut
// off at the moment at which the place first goes below the water. It stays a pocket after that,
// even if the air escapes later: water without film then takes its place.
#pragma once

#include "geometry/SurfaceQuery.h"

#include <dipwright/FilmSolver.h>

#include <memory>
#include <vector>

namespace dipwright {

class SpaceGrid;

// Default number of grid cells along the body's longest edge for the search for air.
inline constexpr int airCells = 96;
// The largest width of a cell, mm (twice this with half as many cells). Long bodies and jigs get
// more cells to keep it, but never more in total than a cube with `airCells`.
inline constexpr float mostAirCell = 1.25f;
// The most layers within the width of a cell. Thin layers resolve shallow hollows. On paths, cells
// are cubes.
inline constexpr int airLayersPerCell = 4;
// The least height of a layer, mm (twice this with half as many cells).
inline constexpr float airLayer = 0.25f;
// The least depth of a pocket, in cells, and its least volume, in volumes of a cell.
inline constexpr int leastPocketDepth = 2;
inline constexpr int leastPocketCells = 32;
// A shallower hollow is a pocket if it has at least this many layers and this many inner grid
// points. The eight neighbours of an inner point in its layer are in the hollow, too. In narrow
// hollows, the grid cannot distinguish trapped air from air that escapes along a slanting ceiling.
inline constexpr int leastPocketLayers = 2;
inline constexpr int leastInnerPoints = 16;

struct AirPocket {
    double level = 0; // y of the water surface under the pocket, mm; on a path, of its lowest place
    BoundingBox box;  // bounding box of its grid points, one cell wider on every side
};

// Returns how many grid cells lie along the longest edge of a box.
int airCellsAlong(const Eigen::Vector3f& sizes, int cells = airCells);

// The air pockets of a body, in the frame of its mesh; +Y is up. Hollows and ways out that are
// narrower than a cell are missed. The inside of an open mesh is not a pocket. Levels are accurate
// to 1/100 of a layer. Immutable; any thread may query it.
class AirPockets {
public:
    // `query` must search `mesh`. Uses all cores; deterministic.
    AirPockets(const TriangleMesh& mesh, const SurfaceQuery& query, int cells = airCells);
    // Does the same for a body that tilts on `path`, given in the frame of the mesh. These pockets
    // are accurate to a cell.
    AirPockets(const TriangleMesh& mesh, const SurfaceQuery& query, const solver::BodyPath& path,
               int cells = airCells);

    bool isEmpty() const { return pockets_.empty(); }
    const std::vector<AirPocket>& all() const { return pockets_; }
    float cell() const { return cell_; } // width of a grid cell, mm

    // Returns the pocket that contains a place outside the body; null in the open and under water.
    // `query` must search the mesh of the constructor.
    const AirPocket* at(const Eigen::Vector3f& place, const SurfaceQuery& query) const;
    // Whether a place on the body is in a pocket. `outward` is the normal of the face at that
    // place.
    bool isDry(const Eigen::Vector3f& place, const Eigen::Vector3f& outward,
               const SurfaceQuery& query) const;

private:
    // Looks a place up in pockets without a level: at the nearest grid point that it sees.
    const AirPocket* atNearestPoint(const Eigen::Vector3f& place, const SurfaceQuery& query) const;
    // Widens the boxes by a cell and keeps the grid, if there are pockets.
    void keep(std::shared_ptr<const SpaceGrid> grid);

    std::vector<AirPocket> pockets_;
    std::vector<std::uint16_t> pocketOf_; // per grid point: number of its pocket from 1; 0 for none
    bool isOnPath_ = false;               // the pockets have no levels
    std::shared_ptr<const SpaceGrid> grid_; // null if there are no pockets
    float cell_ = 0;
};

} // namespace dipwright

// Finds the water level at which the air at each point round a body is cut off from the open.
// Private to this folder.
#pragma once

#include "dip/SpaceGrid.h"

#include <map>

namespace dipwright {

// The grid points are divided into horizontal layers, one cell high and numbered from the top. The
// sweep lowers the water layer by layer. Air at a point "opens" in the first layer at which it has
// a way out that goes no lower.
struct AirSweep {
    static constexpr int never = 0x7fffffff;

    std::vector<int> layer;   // per point: the layer that it is in
    std::vector<int> opensIn; // per point; `never` inside the body and its closed voids
    // Per point: points with the same value are connected through air down to the layer in which
    // they open.
    std::vector<std::uint32_t> chamber;
    // A point that opens below its own layer is in a pocket.
    bool isTrapped(std::size_t point) const {
        return opensIn[point] != never && opensIn[point] > layer[point];
    }
};

// `up` is a unit vector in the grid's coordinates.
AirSweep sweepAir(const SpaceGrid& grid, const Eigen::Vector3f& up);

// The trapped points of one chamber.
struct AirChamber {
    int points = 0;
    int top = AirSweep::never; // its highest layer
    int opensIn = 0;
    int depth() const { return opensIn - top; } // layers
};
// Keyed by AirSweep::chamber.
std::map<std::uint32_t, AirChamber> trappedChambers(const AirSweep& sweep);

} // namespace dipwright

// Finds the water level at which the air at each point round a body is cut off from the open.
// Private to this folder.
#pragma once

#include "dip/SpaceGrid.h"

#include <map>

namespace dipwright {

// The grid points are divided into horizontal layers, one cell high and numbered from the top. The
// sweep lowers the water layer by layer. Air at a point "opens" in the first layer for which it has
// a way out that goes no lower than that layer.
struct AirSweep {
    static constexpr int never = 0x7fffffff;

    std::vector<int> layer; // per grid point: its layer
    // Per grid point: the layer in which its air opens; `never` inside the body and in closed
    // voids.
    std::vector<int> opensIn;
    // Per grid point: the number of its chamber. The air of a chamber is connected above the bottom
    // of the layer in which the chamber opens.
    std::vector<std::uint32_t> chamber;
    // A point that opens below its own layer is in a pocket.
    bool isTrapped(std::size_t point) const {
        return opensIn[point] != never && opensIn[point] > layer[point];
    }
};

// Sweeps the grid. `up` is a unit vector in the grid's coordinates.
AirSweep sweepAir(const SpaceGrid& grid, const Eigen::Vector3f& up);

// The trapped points of one chamber.
struct AirChamber {
    int points = 0;
    int top = AirSweep::never; // its highest layer, which has the smallest number
    int opensIn = 0;
    int depth() const { return opensIn - top; } // layers
};
// Returns the chambers with trapped air, keyed by AirSweep::chamber.
std::map<std::uint32_t, AirChamber> trappedChambers(const AirSweep& sweep);

} // namespace dipwright

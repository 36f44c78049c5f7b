// When the air at each point round a body is cut off from the open as the water rises. Private to
// this folder.
#pragma once

#include "dip/SpaceGrid.h"

#include <map>

namespace dipwright {

// The points of a grid fall into layers by their height, each as high as the grid's cells, numbered
// from the top. Layer after layer the water is let sink: the air at a point opens in the first
// layer down to which it has a way out that goes no lower.
struct AirSweep {
    static constexpr int never = 0x7fffffff;

    std::vector<int> layer;             // a point each: its own
    std::vector<int> opensIn;           // a point each: never inside the body and its closed voids
    std::vector<std::uint32_t> chamber; // a point each: those of one value hang together down to
                                        // the layer in which they open
    // Below its own layer: it is in a pocket.
    bool isTrapped(std::size_t point) const {
        return opensIn[point] != never && opensIn[point] > layer[point];
    }
};

// `up`: unit, in the grid's coordinates.
AirSweep sweepAir(const SpaceGrid& grid, const Eigen::Vector3f& up);

// The trapped points of one chamber.
struct AirChamber {
    int points = 0;
    int top = AirSweep::never; // the first layer
    int opensIn = 0;
    int depth() const { return opensIn - top; } // layers
};
// By AirSweep::chamber.
std::map<std::uint32_t, AirChamber> trappedChambers(const AirSweep& sweep);

} // namespace dipwright

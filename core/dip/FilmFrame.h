// A snapshot of the film during a dip, for display.
#pragma once

#include <dipwright/FilmSolver.h>

#include <cstdint>
#include <functional>
#include <span>

namespace dipwright {

// The film points at one step. Valid only during the observer call.
struct FilmFrame {
    const solver::FilmGrid& grid;
    // Coordinates x, y, z of each point in the world frame (waterline y = 0), mm.
    std::span<const float> positions;
    std::span<const solver::PointState> states;
    // How far the body has come down, mm: its lowest point is at startHeight − descent. On a path:
    // how far the body has travelled.
    double descent = 0;
    std::int64_t steps = 0;
};
using FilmObserver = std::function<void(const FilmFrame&)>;

} // namespace dipwright

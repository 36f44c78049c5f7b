// The film while a dip runs, for display.
#pragma once

#include <dipwright/FilmSolver.h>

#include <cstdint>
#include <functional>
#include <span>

namespace dipwright {

// Film points in the world frame. Valid during the call only.
struct FilmFrame {
    const solver::FilmGrid& grid;
    std::span<const float> positions; // x, y, z a point; world frame, waterline y = 0
    std::span<const solver::PointState> states;
    double descent = 0; // mm; the body's lowest point is at startHeight − descent
    std::int64_t steps = 0;
};
using FilmObserver = std::function<void(const FilmFrame&)>;

} // namespace dipwright

// A film's columns and rows, fine where the body comes down on it and coarse towards its edges.
#pragma once

#include <vector>

namespace dipwright {

// From one cell to the next the spacing grows by no more than this factor, up to so many times the
// finest.
inline constexpr double mostCellGrowth = 1.15;
inline constexpr double coarsestCell = 2.5;

// Lines over a length that is centred on 0, mm, ascending, from −length/2 to length/2: no farther
// apart than `cell` between `from` and `to`, and ever farther beyond, within the limits above.
// `refinement`: so many times as many cells. At 2 every second line is one of the film itself, at
// 1/2 all lines are every second of its. At least `fewest` lines.
std::vector<double> gradedLines(double length, double from, double to, double cell,
                                double refinement, int fewest);

} // namespace dipwright

// Graded columns and rows of a film, fine where the body comes down and coarse towards the edges.
#pragma once

#include <vector>

namespace dipwright {

// The largest ratio between the sizes of neighbouring cells.
inline constexpr double mostCellGrowth = 1.15;
// The size of the largest cell relative to the finest.
inline constexpr double coarsestCell = 8;

// Returns ascending line positions from −length/2 to length/2, mm. Between `from` and `to`, the
// lines are at most `cell` apart. Outside, the spacing grows within the limits above. `refinement`
// multiplies the number of cells. At 2, every second line is a line of the unrefined film. At 1/2,
// every second line of the unrefined film is kept. Returns at least `fewest` lines.
std::vector<double> gradedLines(double length, double from, double to, double cell,
                                double refinement, int fewest);

} // namespace dipwright

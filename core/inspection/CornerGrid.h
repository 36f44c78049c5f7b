// Sorts the corners of chessboard squares into columns and rows. Private to this folder.
#pragma once

#include "inspection/Saddles.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace dipwright {

// Column and row of a corner, counted from a corner near the middle. Both may be negative, and the
// axes may point in any direction.
using GridPlace = std::pair<int, int>;

// Steps to the next corner in the row and in the column, estimated from the neighbours that exist.
struct GridSteps {
    Eigen::Vector2d right = Eigen::Vector2d::Zero(), down = Eigen::Vector2d::Zero();
};

struct CornerGrid {
    std::map<GridPlace, Eigen::Vector2d> corners;

    const Eigen::Vector2d* at(int column, int row) const;
    // Tells whether the corner has a neighbour in its column and a neighbour in its row.
    bool hasSteps(GridPlace place) const;
    // Needs hasSteps().
    GridSteps steps(GridPlace place) const;
};

// Returns all grids of at least twelve corners, starting from the strongest saddles. A saddle is in
// at most one grid.
std::vector<CornerGrid> findGrids(const cv::Mat& blurred, const std::vector<Saddle>& saddles);

} // namespace dipwright

// Corners between squares, put in columns and rows. Private to this folder.
#pragma once

#include "inspection/Saddles.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace dipwright {

// Column and row, from a corner somewhere in the middle, may be negative and may run any way round.
using GridPlace = std::pair<int, int>;

// How far it is to the corner one column, or one row, on: by those beside it that there are.
struct GridSteps {
    Eigen::Vector2d right = Eigen::Vector2d::Zero(), down = Eigen::Vector2d::Zero();
};

struct CornerGrid {
    std::map<GridPlace, Eigen::Vector2d> corners;

    const Eigen::Vector2d* at(int column, int row) const;
    // Only of a corner that has a neighbour in its column and one in its row.
    bool hasSteps(GridPlace place) const;
    GridSteps steps(GridPlace place) const;
};

// All grids of a dozen corners and more, the strongest saddles' first; a saddle is in one at most.
std::vector<CornerGrid> findGrids(const cv::Mat& blurred, const std::vector<Saddle>& saddles);

} // namespace dipwright

// Identifies the board, and the place on it, that a grid of corners shows. Private to this folder.
#pragma once

#include "inspection/CornerGrid.h"
#include "inspection/FindBoards.h"

#include <optional>

namespace dipwright {

// Compares the colours of the squares and their dots with the boards. Returns none if they match no
// place, or more than one.
std::optional<SeenBoard> readBoard(const cv::Mat& blurred, const CornerGrid& grid);

} // namespace dipwright

// Identifies which board, and which part of it, a grid of corners shows. Private to this folder.
#pragma once

#include "inspection/CornerGrid.h"
#include "inspection/FindBoards.h"

#include <optional>

namespace dipwright {

// Compares the colours of the squares and their dots with the boards' patterns. Returns none if
// they match no place of a board, or more than one.
std::optional<SeenBoard> readBoard(const cv::Mat& blurred, const CornerGrid& grid);

} // namespace dipwright

// Which place of which board a grid of corners is. Private to this folder.
#pragma once

#include "inspection/CornerGrid.h"
#include "inspection/FindBoards.h"

#include <optional>

namespace dipwright {

// By the colours of the squares and their dots. Nothing where these fit no place, or more than one.
std::optional<SeenBoard> readBoard(const cv::Mat& blurred, const CornerGrid& grid);

} // namespace dipwright

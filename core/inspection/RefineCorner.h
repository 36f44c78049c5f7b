// Finds the exact point where four squares meet. Private to this folder.
#pragma once

#include "inspection/Saddles.h"

#include <optional>

namespace dipwright {

// Fits two crossing blurred edges to the grey values round a corner,
//   grey = m + c · erf(d₁/s) · erf(d₂/s),   d the distances from the two edges.
// Place, both directions, m, c and s are free; on a bent board, also the bend of each edge. No
// brightness gradient is fitted. Near a blurred corner, a gradient cannot be distinguished from a
// shift, and real gradients across a few pixels are small.
//
// `right` and `down` are the steps to the next corners and give the start directions. Only pixels
// within 36 % of the steps, and within 15 pixels, are used. If 36 % of a step is more than 15
// pixels, reduced pictures are used first. Returns none if the picture does not fit the model. Also
// returns none if the place would move by more than about 25 % of the steps or 10 pixels.
enum class BoardShape { Flat, Bent };
std::optional<Eigen::Vector2d> refinedCorner(const GreyLevels& levels, Eigen::Vector2d place,
                                             const Eigen::Vector2d& right,
                                             const Eigen::Vector2d& down, BoardShape shape);

} // namespace dipwright

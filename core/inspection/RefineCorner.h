// Where exactly four squares meet. Private to this folder.
#pragma once

#include "inspection/Saddles.h"

#include <optional>

namespace dipwright {

// Fits two crossing blurred edges to the grey values round a corner,
//   grey = m + c · erf(d₁/s) · erf(d₂/s),   d the distances from the two edges,
// with place, both directions, m, c and s free; where the board is bent, how much each edge bends,
// too. No slope of the light is among them: near a blurred
// corner it is the same as a shift, and what light does across a few pixels is far less. `right`
// and `down` are the steps to the next corners, which give first directions; what is more than a
// good third of them away is not looked at, nor what is more than 15 pixels away: where squares are
// larger than that, the smaller pictures are looked at first. Nothing where the picture is not like
// that, or the place would move by more than a quarter of the steps, or 10 pixels.
enum class BoardShape { Flat, Bent };
std::optional<Eigen::Vector2d> refinedCorner(const GreyLevels& levels, Eigen::Vector2d place,
                                             const Eigen::Vector2d& right,
                                             const Eigen::Vector2d& down, BoardShape shape);

} // namespace dipwright

// Finds chessboards with dots (sheet/page/CodedBoard.h) in a photo.
#pragma once

#include "sheet/page/CodedBoard.h"

#include <Eigen/Core>

#include <QImage>
#include <vector>

namespace dipwright {

// A point where four squares meet. It has the column and row of the square to its lower right.
struct SeenCorner {
    int column = 0, row = 0;
    Eigen::Vector2d place; // pixels, as in Lens.h
};

struct SeenBoard {
    BoardKind kind = BoardKind::Film;
    bool mirrored = false;           // the board is seen from behind, or the photo is flipped
    std::vector<SeenCorner> corners; // row by row
};

// Returns, for each kind, the board with the most visible corners, refined on the photo. Boards may
// be turned, slanted, dim or partly hidden, and corners may be missing in glare. A board with fewer
// than forty visible squares is not identified and not returned. Uses all cores; the result does
// not depend on their number.
std::vector<SeenBoard> findBoards(const QImage& photo);

} // namespace dipwright

// Chessboards with dots (sheet/page/CodedBoard.h) in a photo.
#pragma once

#include "sheet/page/CodedBoard.h"

#include <Eigen/Core>

#include <QImage>
#include <vector>

namespace dipwright {

// Where four squares meet: the upper left corner of the square of that column and row.
struct SeenCorner {
    int column = 0, row = 0;
    Eigen::Vector2d place; // pixels, as in Lens.h
};

struct SeenBoard {
    BoardKind kind = BoardKind::Film;
    bool mirrored = false;           // seen from behind, or in a picture that was turned over
    std::vector<SeenCorner> corners; // by rows
};

// Of each kind the one of which most corners are seen, refined on the picture: turned, seen at a
// slant, dimly or in part, with corners missing where light glares. A board of which less than
// forty squares are seen is not known and not told. Uses all cores; the same result on any number.
std::vector<SeenBoard> findBoards(const QImage& photo);

} // namespace dipwright

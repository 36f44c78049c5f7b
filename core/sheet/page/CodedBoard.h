// Defines a chessboard that shows, for each of its squares, which square it is and which way round
// the board lies.
//
// Some squares have a dot of the other colour in their middle. A fixed pattern without repetitions
// (isDottedSquare) chooses them. A few neighbouring squares occur at one place of the pattern only,
// and nowhere when turned or mirrored. The two kinds of board share no such group. So a picture may
// show any part of a board, and a board may have any size.
#pragma once

namespace dipwright {

enum class BoardKind {
    Film, // printed on the film that is measured
    Card  // printed on a stiff card beside the film, as the scale for lengths
};

// Edge length of the squares, mm. The film's squares are as large as in the paper's accuracy
// experiment.
constexpr double boardSquare(BoardKind kind) {
    return kind == BoardKind::Film ? 17 : 10;
}

// Columns are counted to the right and rows downwards, both from 0. The upper left square is black.
inline constexpr int mostBoardSquares = 64; // per side
inline constexpr double boardDot = 0.32;    // diameter of a dot, in squares

constexpr bool isBlackSquare(int column, int row) {
    return (column + row) % 2 == 0;
}

// Tells whether a square has a dot. Three of eight squares have one.
bool isDottedSquare(BoardKind kind, int column, int row);

} // namespace dipwright

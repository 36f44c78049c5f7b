// A chessboard that says of each of its places which one it is, and which way round it lies.
//
// Some squares have a dot of the other colour in their middle. Which ones follows a fixed pattern
// without repetitions (hasDot): a few squares side by side are found in one place of it only,
// turned or mirrored ones nowhere, and those of one kind of board not on the other. So a picture
// may show any part of a board, and a board may have any size.
#pragma once

namespace dipwright {

enum class BoardKind {
    Film, // printed on the film that is measured
    Card  // on a stiff card beside it, which says how long a millimetre is
};

// Edge of the squares, mm. The film's are those of the paper's accuracy experiment.
constexpr double boardSquare(BoardKind kind) {
    return kind == BoardKind::Film ? 17 : 10;
}

// Columns count to the right and rows down, both from 0; the square in the upper left is black.
inline constexpr int mostBoardSquares = 64; // a side
inline constexpr double boardDot = 0.32;    // diameter of a dot, in squares

constexpr bool isBlackSquare(int column, int row) {
    return (column + row) % 2 == 0;
}

// Three of eight squares have one.
bool hasDot(BoardKind kind, int column, int row);

} // namespace dipwright

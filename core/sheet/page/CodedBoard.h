// Defines a chessboard whose squares can be identified. A photo of any part of the board shows
// which squares these are and how the board is turned.
//
// Some squares have a dot of the other colour in their middle. A fixed pattern without repetitions
// (isDottedSquare) chooses them. Any group of a few neighbouring squares occurs only once in the
// patterns of both boards, even if it is turned or mirrored. A picture may therefore show any part
// of a board, and a board may have any size.
#pragma once

namespace dipwright {

enum class BoardKind {
    Film, // board printed on the film that is measured
    Card  // board printed on a stiff card beside the film, as the scale for lengths
};

// Edge length of the squares, mm. The film's squares are as large as in the accuracy experiment of
// the 2020 paper.
constexpr double boardSquare(BoardKind kind) {
    return kind == BoardKind::Film ? 17 : 10;
}

inline constexpr int mostBoardSquares = 64; // most squares per side of a board
inline constexpr double boardDot = 0.32;    // diameter of a dot, in squares

// Columns count rightwards and rows downwards, both from 0. The upper left square is black.
constexpr bool isBlackSquare(int column, int row) {
    return (column + row) % 2 == 0;
}

// Tells whether a square has a dot. Three of eight squares have one.
bool isDottedSquare(BoardKind kind, int column, int row);

} // namespace dipwright

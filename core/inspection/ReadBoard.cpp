#include "inspection/ReadBoard.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {

namespace {

constexpr std::size_t leastKnown = 40; // squares whose colour must be known
constexpr double mostWrong = 0.12;     // share of squares that may be wrong at the best place
constexpr double leastAhead = 0.15;    // share of squares by which any other place must be worse

// A square of the grid, between the corners (column, row) and (column + 1, row + 1).
struct Square {
    int column = 0, row = 0;
    double ring = 0, middle = 0; // grey values outside and inside a possible dot
    bool black = false, dot = false;
};

// The position of a grid on a board: place = turn · (grid place) + shift, for corners.
struct Lie {
    std::array<int, 4> turn{1, 0, 0, 1}; // row by row
    int column = 0, row = 0;

    bool isLeftHanded() const { return turn[0] * turn[3] < turn[1] * turn[2]; }
    GridPlace corner(GridPlace place) const {
        return {turn[0] * place.first + turn[1] * place.second + column,
                turn[2] * place.first + turn[3] * place.second + row};
    }
    // On the board, a square has the column and row of its upper left corner.
    GridPlace square(int i, int j) const {
        const GridPlace a = corner({i, j}), b = corner({i + 1, j + 1});
        return {std::min(a.first, b.first), std::min(a.second, b.second)};
    }
};

double meanAround(const cv::Mat& grey, const std::array<Eigen::Vector2d, 4>& corners,
                  std::initializer_list<std::pair<double, double>> places) {
    double sum = 0;
    for (const auto& [u, v] : places) {
        sum += greyAt(grey, (1 - v) * ((1 - u) * corners[0] + u * corners[1]) +
                                v * ((1 - u) * corners[2] + u * corners[3]));
    }
    return sum / double(places.size());
}

std::vector<Square> squaresOf(const cv::Mat& grey, const CornerGrid& grid) {
    std::vector<Square> squares;
    for (const auto& [at, place] : grid.corners) {
        const auto [i, j] = at;
        const auto *right = grid.at(i + 1, j), *below = grid.at(i, j + 1),
                   *last = grid.at(i + 1, j + 1);
        if (!right || !below || !last) {
            continue;
        }
        const std::array<Eigen::Vector2d, 4> corners{place, *right, *below, *last};
        Square square{i, j};
        square.ring = meanAround(grey, corners,
                                 {{0.22, 0.22},
                                  {0.5, 0.2},
                                  {0.78, 0.22},
                                  {0.2, 0.5},
                                  {0.8, 0.5},
                                  {0.22, 0.78},
                                  {0.5, 0.8},
                                  {0.78, 0.78}});
        square.middle = meanAround(
            grey, corners, {{0.5, 0.5}, {0.45, 0.5}, {0.55, 0.5}, {0.5, 0.45}, {0.5, 0.55}});
        squares.push_back(square);
    }
    return squares;
}

// Decides by comparison with neighbouring squares whether a square is black or white. Drops squares
// that do not differ from their neighbours.
std::vector<Square> judged(std::vector<Square> squares, const std::vector<Square>& all) {
    std::map<GridPlace, double> rings;
    for (const Square& square : all) {
        rings[{square.column, square.row}] = square.ring;
    }
    std::erase_if(squares, [&](Square& square) {
        double sum = 0;
        int count = 0;
        for (const auto& [dx, dy] : {GridPlace{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const auto beside = rings.find({square.column + dx, square.row + dy});
            if (beside != rings.end()) {
                sum += beside->second;
                ++count;
            }
        }
        const double step = count > 0 ? sum / count - square.ring : 0;
        square.black = step > 0;
        square.dot = (square.middle - square.ring) * step > 0.35 * step * step;
        return std::abs(step) < 0.03;
    });
    return squares;
}

struct Match {
    BoardKind kind = BoardKind::Film;
    Lie lie;
    double wrong = 1; // share of the squares
};

// The board's pattern, computed once.
using Pattern = std::array<std::array<bool, mostBoardSquares>, mostBoardSquares>;

Pattern patternOf(BoardKind kind) {
    Pattern pattern{};
    for (int row = 0; row < mostBoardSquares; ++row) {
        for (int column = 0; column < mostBoardSquares; ++column) {
            pattern[std::size_t(row)][std::size_t(column)] = isDottedSquare(kind, column, row);
        }
    }
    return pattern;
}

// Returns the number of wrong squares; stops counting above `most`.
std::size_t wrongSquares(const std::vector<Square>& squares, const Pattern& pattern, const Lie& lie,
                         std::size_t most) {
    std::size_t wrong = 0;
    for (const Square& square : squares) {
        const auto [column, row] = lie.square(square.column, square.row);
        const bool isOn =
            column >= 0 && row >= 0 && column < mostBoardSquares && row < mostBoardSquares;
        wrong += !isOn || square.black != isBlackSquare(column, row) ||
                 square.dot != pattern[std::size_t(row)][std::size_t(column)];
        if (wrong > most) {
            break;
        }
    }
    return wrong;
}

// Tries all shifts of one kind of board at one turn. Updates `best`, the two best matches so far.
void tryShifts(const std::vector<Square>& squares, BoardKind kind, const Pattern& pattern,
               const std::array<int, 4>& turn, std::array<Match, 2>& best) {
    Lie lie{turn};
    GridPlace least{1 << 20, 1 << 20}, most{-(1 << 20), -(1 << 20)};
    for (const Square& square : squares) {
        const auto [column, row] = lie.square(square.column, square.row);
        least = {std::min(least.first, column), std::min(least.second, row)};
        most = {std::max(most.first, column), std::max(most.second, row)};
    }
    for (lie.row = -least.second; lie.row < mostBoardSquares - most.second; ++lie.row) {
        for (lie.column = -least.first; lie.column < mostBoardSquares - most.first; ++lie.column) {
            const auto bound = std::size_t(best[1].wrong * double(squares.size()));
            const double wrong =
                double(wrongSquares(squares, pattern, lie, bound)) / double(squares.size());
            if (wrong < best[1].wrong) {
                best[1] = {kind, lie, wrong};
                if (wrong < best[0].wrong) {
                    std::swap(best[0], best[1]);
                }
            }
        }
    }
}

// Tells whether a grid is mirrored in the photo: its rows run to the left of its columns.
bool isLeftHanded(const CornerGrid& grid) {
    for (const auto& [place, corner] : grid.corners) {
        if (grid.hasSteps(place)) {
            const GridSteps steps = grid.steps(place);
            return steps.right.x() * steps.down.y() < steps.right.y() * steps.down.x();
        }
    }
    return false;
}

} // namespace

std::optional<SeenBoard> readBoard(const cv::Mat& blurred, const CornerGrid& grid) {
    const std::vector<Square> all = squaresOf(blurred, grid);
    const std::vector<Square> squares = judged(all, all);
    if (squares.size() < leastKnown) {
        return std::nullopt;
    }
    std::array<Match, 2> best{};
    for (const BoardKind kind : {BoardKind::Film, BoardKind::Card}) {
        const Pattern pattern = patternOf(kind);
        for (const auto& turn : {std::array{1, 0, 0, 1},
                                 {0, -1, 1, 0},
                                 {-1, 0, 0, -1},
                                 {0, 1, -1, 0},
                                 {-1, 0, 0, 1},
                                 {1, 0, 0, -1},
                                 {0, 1, 1, 0},
                                 {0, -1, -1, 0}}) {
            tryShifts(squares, kind, pattern, turn, best);
        }
    }
    if (best[0].wrong > mostWrong || best[1].wrong < best[0].wrong + leastAhead) {
        return std::nullopt;
    }
    const Lie& lie = best[0].lie;
    SeenBoard board{best[0].kind, isLeftHanded(grid) != lie.isLeftHanded(), {}};
    for (const auto& [place, corner] : grid.corners) {
        const auto [column, row] = lie.corner(place);
        // Corners on the board's own edge are left out, because four squares do not meet there.
        if (column > 0 && row > 0) {
            board.corners.push_back({column, row, corner});
        }
    }
    return board;
}

} // namespace dipwright

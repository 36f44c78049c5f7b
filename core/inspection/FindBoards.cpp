#include "inspection/FindBoards.h"

#include "inspection/ReadBoard.h"
#include "inspection/RefineCorner.h"
#include "parallel/ParallelFor.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace dipwright {

namespace {

// The photo is searched at several sizes, because a board may be small in it, or blurred.
constexpr std::array<int, 3> lengths{900, 1800, 3600}; // pixels of the longer side

// Removes points that are not in line with their neighbours and are therefore not corners.
CornerGrid inLine(CornerGrid grid) {
    constexpr double mostBend =
        0.1; // largest change from one step to the next, as a share of the step
    std::map<GridPlace, std::pair<int, int>>
        triples; // per corner: number of all lines, of bent lines
    for (const auto& [at, place] : grid.corners) {
        for (const auto& [dx, dy] : {GridPlace{1, 0}, {0, 1}}) {
            const auto [i, j] = at;
            const auto *next = grid.at(i + dx, j + dy), *last = grid.at(i + 2 * dx, j + 2 * dy);
            if (next && last) {
                const Eigen::Vector2d bend = place + *last - 2 * *next;
                const bool isBent = bend.norm() > mostBend * (*last - place).norm() / 2;
                for (const int step : {0, 1, 2}) {
                    auto& [all, bent] = triples[{i + step * dx, j + step * dy}];
                    ++all;
                    bent += isBent;
                }
            }
        }
    }
    std::erase_if(grid.corners, [&](const auto& corner) {
        const auto& [all, bent] = triples[corner.first];
        return all == bent;
    });
    return grid;
}

// Moves corners to their exact places in the photo and drops corners that the photo does not show.
CornerGrid refined(const GreyLevels& grey, const CornerGrid& grid) {
    std::vector<GridPlace> places;
    for (const auto& [at, place] : grid.corners) {
        if (grid.hasSteps(at)) {
            places.push_back(at);
        }
    }
    std::vector<std::optional<Eigen::Vector2d>> found(places.size());
    parallelFor(std::size_t(0), places.size(), [&](std::size_t i) {
        const GridSteps steps = grid.steps(places[i]);
        found[i] = refinedCorner(grey, grid.corners.at(places[i]), steps.right, steps.down,
                                 BoardShape::Flat);
    });
    CornerGrid result;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (found[i]) {
            result.corners[places[i]] = *found[i];
        }
    }
    return inLine(std::move(result));
}

// Sorts the corners row by row.
std::vector<SeenCorner> refined(const GreyLevels& grey, const std::vector<SeenCorner>& corners) {
    CornerGrid grid;
    for (const SeenCorner& corner : corners) {
        grid.corners[{corner.column, corner.row}] = corner.place;
    }
    std::vector<SeenCorner> result;
    for (const auto& [at, place] : refined(grey, grid).corners) {
        result.push_back({at.first, at.second, place});
    }
    std::sort(result.begin(), result.end(), [](const SeenCorner& a, const SeenCorner& b) {
        return std::pair(a.row, a.column) < std::pair(b.row, b.column);
    });
    return result;
}

void keepLargest(std::vector<SeenBoard>& boards, SeenBoard board) {
    for (SeenBoard& known : boards) {
        if (known.kind == board.kind) {
            if (known.corners.size() < board.corners.size()) {
                known = std::move(board);
            }
            return;
        }
    }
    boards.push_back(std::move(board));
}

} // namespace

std::vector<SeenBoard> findBoards(const QImage& photo) {
    const cv::Mat grey = greyOf(photo);
    std::vector<SeenBoard> boards;
    for (const int length : lengths) {
        const cv::Mat small = shortened(grey, length);
        const Eigen::Vector2d scale(double(grey.cols) / small.cols, double(grey.rows) / small.rows);
        cv::Mat blurred;
        cv::GaussianBlur(small, blurred, {}, 1);
        for (const CornerGrid& grid : findGrids(blurred, findSaddles(blurred))) {
            if (auto board = readBoard(blurred, grid)) {
                for (SeenCorner& corner : board->corners) {
                    corner.place = corner.place.cwiseProduct(scale);
                }
                keepLargest(boards, std::move(*board));
            }
        }
        if (small.cols == grey.cols) {
            break;
        }
    }
    const GreyLevels levels = levelsOf(grey);
    for (SeenBoard& board : boards) {
        board.corners = refined(levels, board.corners);
    }
    return boards;
}

} // namespace dipwright

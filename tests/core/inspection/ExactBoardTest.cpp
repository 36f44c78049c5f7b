// Tests the search for corners in generated chessboards, which have no noise and no blur. Their
// corners lie on the boundaries between pixels, or anywhere in a pixel.
#include "inspection/CornerGrid.h"
#include "inspection/RefineCorner.h"

#include <opencv2/imgproc.hpp>

#include <QtTest>

#include <cmath>
#include <map>

using namespace dipwright;

namespace {

struct Board {
    int squares;   // per side
    double square; // pixels
    Eigen::Vector2d shift;
};

// Returns the mean of a square wave of ±1 over a pixel. The wave changes at multiples of `square`.
double waveIn(int pixel, double square, double shift) {
    constexpr int samples = 64;
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        const double at = pixel + (i + 0.5) / samples - shift;
        sum += int(std::floor(at / square)) % 2 == 0 ? 1 : -1;
    }
    return sum / samples;
}

cv::Mat pictureOf(const Board& board) {
    const int side = int(std::ceil(board.squares * board.square));
    cv::Mat grey(side, side, CV_32F);
    std::vector<double> across, down;
    for (int i = 0; i < side; ++i) {
        across.push_back(waveIn(i, board.square, board.shift.x()));
        down.push_back(waveIn(i, board.square, board.shift.y()));
    }
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            grey.at<float>(row, column) =
                float(0.5 + 0.5 * across[std::size_t(column)] * down[std::size_t(row)]);
        }
    }
    return grey;
}

// Returns how far a place is from the nearest corner of the board, in pixels.
double offCorner(const Board& board, const Eigen::Vector2d& place) {
    const Eigen::Array2d squares = (place - board.shift).array() / board.square;
    return board.square * (squares - squares.round()).matrix().norm();
}

} // namespace

class ExactBoardTest : public QObject {
    Q_OBJECT

private slots:
    void findGrids_exactBoard_oneCornerPerSaddle_data() {
        QTest::addColumn<int>("squares");
        QTest::addColumn<double>("square");
        for (const auto& [squares, square] :
             {std::pair(16, 32.0), std::pair(16, 64.0), std::pair(12, 40.0), std::pair(8, 15.0),
              std::pair(12, 33.0), std::pair(12, 40.25), std::pair(12, 28.5)}) {
            QTest::addRow("%d squares of %g pixels", squares, square) << squares << square;
        }
    }

    void findGrids_exactBoard_oneCornerPerSaddle() {
        QFETCH(int, squares);
        QFETCH(double, square);
        for (const Eigen::Vector2d& shift : std::initializer_list<Eigen::Vector2d>{
                 {0, 0}, {0.5, 0.5}, {0.5, 0}, {0.3, -0.2}, {0.01, 0.47}}) {
            const Board board{squares, square, shift};
            const cv::Mat grey = pictureOf(board);
            cv::Mat blurred;
            cv::GaussianBlur(grey, blurred, {}, 1);
            const std::vector<Saddle> saddles = findSaddles(blurred);
            const std::size_t corners = std::size_t(squares - 1) * std::size_t(squares - 1);
            QCOMPARE(saddles.size(), corners);
            for (const Saddle& saddle : saddles) {
                const double off = offCorner(board, saddle.place);
                QVERIFY2(off < 0.1, qPrintable(QString::number(off)));
            }
            const std::vector<CornerGrid> grids = findGrids(blurred, saddles);
            QCOMPARE(grids.size(), std::size_t(1));
            QCOMPARE(grids.front().corners.size(), corners);
            const GreyLevels levels = levelsOf(blurred);
            for (const auto& [at, place] : grids.front().corners) {
                if (at.first != at.second) {
                    continue; // refinement is slow, and the corners of the diagonal are enough
                }
                const GridSteps steps = grids.front().steps(at);
                const auto exact =
                    refinedCorner(levels, place, steps.right, steps.down, BoardShape::Flat);
                QVERIFY(exact);
                const double off = offCorner(board, *exact);
                QVERIFY2(off < 0.02, qPrintable(QString::number(off)));
            }
        }
    }
};

QTEST_APPLESS_MAIN(ExactBoardTest)
#include "ExactBoardTest.moc"

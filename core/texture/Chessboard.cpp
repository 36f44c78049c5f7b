#include "texture/Chessboard.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright {

namespace {

// Returns the total length of odd squares between the film's middle and `place`. An even square
// begins at the middle. Negative for places before the middle.
double oddLength(double place, double square) {
    const double pair = 2 * square;
    const double pairs = std::floor(place / pair);
    return pairs * square + std::max(0.0, place - pairs * pair - square);
}

// Returns the share, 0 … 1, of each pixel that lies in odd squares, for `pixels` along a film of
// `length` mm. Shares between 0 and 1 at borders give the squares their exact size at any
// resolution.
std::vector<double> oddShares(int pixels, double length, double square) {
    std::vector<double> odd;
    odd.reserve(std::size_t(pixels));
    const double size = length / pixels;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double place = pixel * size - length / 2;
        odd.push_back((oddLength(place + size, square) - oddLength(place, square)) / size);
    }
    return odd;
}

} // namespace

QImage chessboard(const solver::FilmGrid& grid, double square, QSize pixels) {
    const std::vector<double> columns = oddShares(pixels.width(), grid.width, square);
    const std::vector<double> rows = oddShares(pixels.height(), grid.depth, square);
    QImage image(pixels, QImage::Format_RGBA8888);
    for (int row = 0; row < pixels.height(); ++row) {
        auto* pixel = image.scanLine(row);
        for (int column = 0; column < pixels.width(); ++column, pixel += 4) {
            const double across = columns[std::size_t(column)];
            const double down = rows[std::size_t(row)];
            const double white = across * (1 - down) + down * (1 - across);
            pixel[0] = pixel[1] = pixel[2] = uchar(std::lround(255 * white));
            pixel[3] = 255;
        }
    }
    return image;
}

} // namespace dipwright

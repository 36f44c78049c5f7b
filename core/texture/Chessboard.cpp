#include "texture/Chessboard.h"

#include <cmath>

namespace dipwright {

namespace {

// For each of `pixels` along a film of `length` mm: whether it is in an odd square.
std::vector<bool> oddSquares(int pixels, double length, double square) {
    std::vector<bool> odd;
    odd.reserve(std::size_t(pixels));
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double place = ((pixel + 0.5) / pixels - 0.5) * length;
        odd.push_back(std::fmod(std::floor(place / square), 2) != 0);
    }
    return odd;
}

} // namespace

QImage chessboard(const solver::FilmGrid& grid, double square, QSize pixels) {
    const std::vector<bool> columns = oddSquares(pixels.width(), grid.width, square);
    const std::vector<bool> rows = oddSquares(pixels.height(), grid.depth, square);
    QImage image(pixels, QImage::Format_RGBA8888);
    for (int row = 0; row < pixels.height(); ++row) {
        auto* pixel = image.scanLine(row);
        for (int column = 0; column < pixels.width(); ++column, pixel += 4) {
            const bool white = rows[std::size_t(row)] != columns[std::size_t(column)];
            pixel[0] = pixel[1] = pixel[2] = white ? 255 : 0;
            pixel[3] = 255;
        }
    }
    return image;
}

} // namespace dipwright

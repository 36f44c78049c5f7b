#include "texture/Bleed.h"

#include "parallel/ParallelFor.h"
#include "texture/LinearLight.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace dipwright {

namespace {

constexpr std::int16_t none = std::numeric_limits<std::int16_t>::max();

// Holds the row distance from each pixel to the nearest printed pixel of its column. Positive
// distances lead downwards; `none` means farther than `radius`.
class ColumnDistances {
public:
    ColumnDistances(const QImage& image, int radius)
        : width_(image.width()), down_(std::size_t(image.width()) * std::size_t(image.height())) {
        parallelForPieces(0, width_, 256,
                          [&](int begin, int end) { sweep(image, begin, end, radius); });
    }
    const std::int16_t* row(int row) const {
        return &down_[std::size_t(row) * std::size_t(width_)];
    }

private:
    std::int16_t& at(int row, int column) {
        return down_[std::size_t(row) * std::size_t(width_) + std::size_t(column)];
    }
    void sweep(const QImage& image, int begin, int end, int radius) {
        const PixelCode code(image);
        std::vector<int> since(static_cast<std::size_t>(end - begin), radius + 1);
        for (int row = 0; row < image.height(); ++row) {
            const auto* pixels = image.constScanLine(row);
            for (int column = begin; column < end; ++column) {
                int& rows = since[std::size_t(column - begin)];
                rows = code.alpha(pixels + column * code.bytes()) != 0
                           ? 0
                           : std::min(rows + 1, radius + 1);
                at(row, column) = std::int16_t(rows <= radius ? -rows : none);
            }
        }
        std::fill(since.begin(), since.end(), radius + 1);
        for (int row = image.height() - 1; row >= 0; --row) {
            for (int column = begin; column < end; ++column) {
                int& rows = since[std::size_t(column - begin)];
                std::int16_t& nearest = at(row, column);
                rows = nearest == 0 ? 0 : std::min(rows + 1, radius + 1);
                if (rows <= radius && (nearest == none || rows < -nearest)) {
                    nearest = std::int16_t(rows);
                }
            }
        }
    }

    int width_;
    std::vector<std::int16_t> down_;
};

template <typename Pixel>
void continueRow(Pixel* pixels, std::ptrdiff_t stride, int width, const std::int16_t* down,
                 double radius) {
    const int reach = int(radius);
    const double limit = radius * radius;
    // The column of the rightmost candidate so far. If this column is more than `reach` to the
    // left, no candidate is near.
    int lastCandidate = -2 * reach - 2;
    int scanned = 0;
    for (int column = 0; column < width; ++column) {
        for (; scanned < width && scanned <= column + reach; ++scanned) {
            if (down[scanned] != none) {
                lastCandidate = scanned;
            }
        }
        if (down[column] == 0 || lastCandidate < column - reach) {
            continue;
        }
        double nearest = limit;
        std::ptrdiff_t source = 0;
        for (int other = std::max(0, column - reach); other <= std::min(width - 1, column + reach);
             ++other) {
            if (down[other] == none) {
                continue;
            }
            const double across = other - column;
            const double along = down[other];
            const double squared = across * across + along * along;
            if (squared <= nearest && (source == 0 || squared < nearest)) {
                nearest = squared;
                source = down[other] * stride + (other - column);
            }
        }
        if (source != 0) {
            pixels[column] = pixels[column + source];
        }
    }
}

// Returns the first and last printed pixel of a row. If the row has no printed pixel, the first is
// greater than the last.
std::pair<int, int> printedPart(const PixelCode& code, const uchar* pixels, int width) {
    int first = 0;
    while (first < width && code.alpha(pixels + first * code.bytes()) == 0) {
        ++first;
    }
    int last = width - 1;
    while (last > first && code.alpha(pixels + last * code.bytes()) == 0) {
        --last;
    }
    return {first, last};
}

// Returns the smallest box around all printed pixels, enlarged by `margin` pixels.
QRect reachedBox(const QImage& image, int margin) {
    const PixelCode code(image);
    std::vector<std::pair<int, int>> parts(std::size_t(image.height()));
    parallelFor(0, image.height(), [&](int row) {
        parts[std::size_t(row)] = printedPart(code, image.constScanLine(row), image.width());
    });
    QRect printed;
    for (int row = 0; row < image.height(); ++row) {
        const auto [first, last] = parts[std::size_t(row)];
        if (first <= last) {
            printed |= QRect(QPoint(first, row), QPoint(last, row));
        }
    }
    return printed.isEmpty()
               ? QRect()
               : printed.adjusted(-margin, -margin, margin, margin).intersected(image.rect());
}

// Returns an image that shares the pixels of a part of `image`. It must not outlive `image`.
QImage partOf(QImage& image, const QRect& box) {
    const qsizetype left = PixelCode(image).bytes() * qsizetype(box.x());
    return {image.bits() + box.y() * image.bytesPerLine() + left, box.width(), box.height(),
            image.bytesPerLine(), image.format()};
}

template <typename Pixel>
void continueWithin(QImage& image, double within) {
    const ColumnDistances distances(image, int(within));
    auto* pixels = reinterpret_cast<Pixel*>(image.bits());
    const auto stride = image.bytesPerLine() / std::ptrdiff_t(sizeof(Pixel));
    parallelFor(0, image.height(), [&, width = image.width()](int row) {
        continueRow(pixels + row * stride, stride, width, distances.row(row), within);
    });
}

} // namespace

void continueColour(QImage& image, double radius) {
    const double within = std::min(radius, 10000.0);
    const QRect box = within < 1 ? QRect() : reachedBox(image, int(within));
    if (!box.isEmpty()) {
        QImage part = partOf(image, box);
        if (PixelCode(image).isWide()) {
            continueWithin<std::uint64_t>(part, within);
        } else {
            continueWithin<std::uint32_t>(part, within);
        }
    }
}

} // namespace dipwright

#include "base/ImageRows.h"

#include <QColorSpace>
#include <QPixelFormat>

#include <algorithm>
#include <cstdlib>

namespace dipwright {
namespace {

constexpr int pixelsAtOnce = 1 << 20;

} // namespace

QImage blankImage(QSize pixels, QImage::Format format) {
    const qsizetype bits = QImage::toPixelFormat(format).bitsPerPixel();
    const qsizetype stride = (qsizetype(pixels.width()) * bits + 31) / 32 * 4;
    void* const zeros = std::calloc(std::size_t(pixels.height()), std::size_t(stride));
    if (!zeros) {
        return {};
    }
    return {static_cast<uchar*>(zeros),
            pixels.width(),
            pixels.height(),
            stride,
            format,
            std::free,
            zeros};
}

QImage imageRows(const QImage& image, int first, int end) {
    QImage rows(image.constScanLine(first), image.width(), end - first, image.bytesPerLine(),
                image.format());
    rows.setColorTable(image.colorTable());
    rows.setColorSpace(image.colorSpace());
    return rows;
}

void forImageRows(const QImage& image,
                  const std::function<void(const QImage& rows, int first)>& work) {
    const int step = std::max(pixelsAtOnce / std::max(image.width(), 1), 1);
    for (int first = 0; first < image.height(); first += step) {
        work(imageRows(image, first, std::min(first + step, image.height())), first);
    }
}

} // namespace dipwright

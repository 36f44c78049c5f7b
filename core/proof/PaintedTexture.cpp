#include "proof/PaintedTexture.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <bit>

namespace dipwright {
namespace {

int powerOfTwo(int texels, int most) {
    // A side that is a little too long for one size is drawn in it all the same.
    const auto wanted = unsigned(std::max(1, texels * 7 / 8));
    return std::min(int(std::bit_ceil(wanted)), most);
}

// Returns the place of the triangle nearest to a point of its chart, both in texels.
SurfacePoint placeIn(const std::array<Eigen::Vector2f, 3>& corners, std::uint32_t triangle,
                     const Eigen::Vector2f& point) {
    const Eigen::Vector2f b = corners[1] - corners[0], c = corners[2] - corners[0];
    const Eigen::Vector2f p = point - corners[0];
    const float area = b.x() * c.y() - b.y() * c.x();
    const float second = (p.x() * c.y() - p.y() * c.x()) / area;
    const float third = (b.x() * p.y() - b.y() * p.x()) / area;
    Eigen::Vector3f weights(1 - second - third, second, third);
    if (!weights.allFinite()) {
        return middleOf(triangle);
    }
    weights = weights.cwiseMax(0.0F);
    return {triangle, weights / weights.sum()};
}

// The mean of the pixels that are set (opaque); transparent if none is.
QRgb meanOf(const std::array<QRgb, 4>& pixels) {
    int red = 0, green = 0, blue = 0, count = 0;
    for (const QRgb pixel : pixels) {
        if (qAlpha(pixel) != 0) {
            red += qRed(pixel);
            green += qGreen(pixel);
            blue += qBlue(pixel);
            ++count;
        }
    }
    return count == 0 ? qRgba(0, 0, 0, 0) : qRgb(red / count, green / count, blue / count);
}

QRgb* row(QImage& picture, int y) {
    return reinterpret_cast<QRgb*>(picture.scanLine(y));
}

const QRgb* row(const QImage& picture, int y) {
    return reinterpret_cast<const QRgb*>(picture.constScanLine(y));
}

// Fills transparent pixels with the colours beside them, from ever smaller copies of the picture.
void fill(QImage& picture) {
    if (picture.width() == 1 && picture.height() == 1) {
        return;
    }
    QImage half(std::max(1, picture.width() / 2), std::max(1, picture.height() / 2),
                QImage::Format_ARGB32);
    const auto clamped = [&](int x, int y) {
        return row(std::as_const(picture),
                   std::min(y, picture.height() - 1))[std::min(x, picture.width() - 1)];
    };
    for (int y = 0; y < half.height(); ++y) {
        for (int x = 0; x < half.width(); ++x) {
            row(half, y)[x] = meanOf({clamped(2 * x, 2 * y), clamped(2 * x + 1, 2 * y),
                                      clamped(2 * x, 2 * y + 1), clamped(2 * x + 1, 2 * y + 1)});
        }
    }
    fill(half);
    for (int y = 0; y < picture.height(); ++y) {
        QRgb* pixels = row(picture, y);
        const QRgb* coarse = row(std::as_const(half), std::min(y / 2, half.height() - 1));
        for (int x = 0; x < picture.width(); ++x) {
            if (qAlpha(pixels[x]) == 0) {
                pixels[x] = coarse[std::min(x / 2, half.width() - 1)];
            }
        }
    }
}

} // namespace

QImage paintedTexture(const Unwrapping& charts, int most,
                      const std::function<QRgb(const SurfacePoint&)>& colour,
                      const CancelToken& cancelToken) {
    QImage picture(powerOfTwo(charts.width, most), powerOfTwo(charts.height, most),
                   QImage::Format_ARGB32);
    picture.fill(Qt::transparent);
    const Eigen::Vector2f scale(float(charts.width) / float(picture.width()),
                                float(charts.height) / float(picture.height()));
    uchar* const bits = picture.bits();
    const qsizetype stride = picture.bytesPerLine();
    parallelFor(0, picture.height(), [&](int y) {
        if (cancelToken.isCancelled()) {
            return;
        }
        auto* pixels = reinterpret_cast<QRgb*>(bits + y * stride);
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector2f point =
                scale.cwiseProduct(Eigen::Vector2f(float(x) + 0.5F, float(y) + 0.5F));
            const std::size_t texel = std::size_t(std::min(int(point.y()), charts.height - 1)) *
                                          std::size_t(charts.width) +
                                      std::size_t(std::min(int(point.x()), charts.width - 1));
            const std::uint32_t triangle = charts.owner[texel];
            if (triangle != Unwrapping::nobody) {
                pixels[x] =
                    colour(placeIn(charts.corners[triangle], triangle, point)) | 0xff000000U;
            }
        }
    });
    cancelToken.throwIfCancelled();
    fill(picture);
    return picture;
}

} // namespace dipwright

#include "texture/StretchPlane.h"

#include "base/WideGamut.h"
#include "texture/LinearLight.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

const float least = std::log(leastAreaStretch);
const float steps = 65535 / (std::log(mostAreaStretch) - least);

} // namespace

std::uint16_t stretchCode(float areaStretch) {
    const float within = std::clamp(areaStretch, leastAreaStretch, mostAreaStretch);
    return std::uint16_t(std::lround((std::log(within) - least) * steps));
}

float areaStretchOf(std::uint16_t code) {
    return std::exp(least + float(code) / steps);
}

QImage unstretched(QSize pixels) {
    QImage plane(pixels, QImage::Format_Grayscale16);
    const std::uint16_t code = stretchCode(1);
    for (int y = 0; y < plane.height(); ++y) {
        std::fill_n(reinterpret_cast<std::uint16_t*>(plane.scanLine(y)), plane.width(), code);
    }
    return plane;
}

QImage pictureOfStretch(const QImage& plane, const QImage& film) {
    const PixelCode code(film);
    QImage picture(plane.size(), QImage::Format_RGBA64);
    for (int y = 0; y < plane.height(); ++y) {
        const auto* codes = reinterpret_cast<const std::uint16_t*>(plane.constScanLine(y));
        auto* channels = reinterpret_cast<std::uint16_t*>(picture.scanLine(y));
        const uchar* pixel = film.isNull() ? nullptr : film.constScanLine(y);
        for (int x = 0; x < plane.width(); ++x, channels += 4) {
            const bool isPainted = !pixel || code.alpha(pixel + code.bytes() * x) != 0;
            std::fill_n(channels, 3, isPainted ? codes[x] : 0);
            channels[3] = isPainted ? 65535 : 0;
        }
    }
    picture.setColorSpace(wideSpace());
    return picture;
}

QImage stretchOfPicture(const QImage& picture) {
    QImage plane = unstretched(picture.size());
    for (int y = 0; y < plane.height(); ++y) {
        const auto* channels = reinterpret_cast<const std::uint16_t*>(picture.constScanLine(y));
        auto* codes = reinterpret_cast<std::uint16_t*>(plane.scanLine(y));
        for (int x = 0; x < plane.width(); ++x, channels += 4) {
            codes[x] = channels[3] != 0 ? channels[0] : codes[x];
        }
    }
    return plane;
}

} // namespace dipwright

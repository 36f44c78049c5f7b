#include "texture/InkAppearance.h"

#include "base/InkPicture.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"
#include "texture/LinearLight.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

QImage wideWhite(QSize size) {
    QImage picture(size, QImage::Format_RGBA64);
    if (picture.isNull()) {
        throw std::bad_alloc();
    }
    picture.fill(Qt::white);
    picture.setColorSpace(wideSpace());
    return picture;
}

// Returns the code in a wide picture of every amount.
std::array<quint16, 256> codesOfAmounts() {
    std::array<quint16, 256> codes{};
    for (std::size_t amount = 0; amount < codes.size(); ++amount) {
        codes[amount] = quint16(std::lround(65535 * srgbFromLinear(1 - double(amount) / 255)));
    }
    return codes;
}

QImage planeOf(const QImage& inks, InkPlane plane) {
    const std::array<quint16, 256> codes = codesOfAmounts();
    QImage picture = wideWhite(inks.size());
    uchar* const bits = picture.bits();
    parallelFor(0, inks.height(), [&, stride = picture.bytesPerLine()](int y) {
        const uchar* from = inks.constScanLine(y);
        auto* to = reinterpret_cast<quint16*>(bits + y * stride);
        for (int x = 0; x < inks.width(); ++x, from += 4, to += 4) {
            if (plane == InkPlane::Colours) {
                std::transform(from, from + 3, to, [&](uchar amount) { return codes[amount]; });
            } else {
                to[0] = codes[from[3]];
                to[1] = 0;
            }
        }
    });
    return picture;
}

} // namespace

QString inkSpaceOf(const SurfaceAppearance& appearance) {
    const auto found = std::find_if(appearance.inks.begin(), appearance.inks.end(),
                                    [](const QImage& inks) { return !inks.isNull(); });
    return found == appearance.inks.end() ? QString() : inkSpace(*found);
}

SurfaceAppearance inkAppearance(const SurfaceAppearance& appearance, InkPlane plane) {
    const QString space = inkSpaceOf(appearance);
    SurfaceAppearance result = appearance;
    result.inks.clear();
    for (Material& material : result.materials) {
        material.colour = Qt::white;
    }
    for (std::size_t texture = 0; texture < result.textures.size(); ++texture) {
        const QImage& inks = appearance.inks[texture];
        result.textures[texture] =
            !inks.isNull() && inkSpace(inks) == space ? planeOf(inks, plane) : wideWhite({1, 1});
    }
    return result;
}

} // namespace dipwright

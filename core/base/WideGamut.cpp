#include "base/WideGamut.h"

#include <QColorTransform>

#include <cmath>
#include <new>
#include <vector>

namespace dipwright {
namespace {

constexpr double fullNumber = 65535;

const std::vector<double>& lightTable() {
    static const std::vector<double> table = [] {
        std::vector<double> light;
        light.reserve(std::size_t(fullNumber) + 1);
        for (int number = 0; number <= int(fullNumber); ++number) {
            light.push_back(linearFromSrgb(number / fullNumber));
        }
        return light;
    }();
    return table;
}

QImage converted(const QImage& picture, const QColorSpace& from, const QColorSpace& to) {
    QImage result = picture.convertToFormat(QImage::Format_RGBA64);
    if (result.isNull()) {
        throw std::bad_alloc();
    }
    result.setColorSpace(from);
    result.convertToColorSpace(to);
    return result;
}

} // namespace

double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

bool isWide(const QImage& picture) {
    return picture.format() == QImage::Format_RGBA64 || picture.format() == QImage::Format_RGBX64;
}

QColorSpace wideSpace() {
    return {QPointF(0.3127, 0.3290), QPointF(0.708, 0.292), QPointF(0.170, 0.797),
            QPointF(0.131, 0.046), QColorSpace::TransferFunction::SRgb};
}

QImage inSrgb(const QImage& picture) {
    if (!isWide(picture)) {
        return picture;
    }
    QImage result = converted(picture, wideSpace(), QColorSpace::SRgb);
    result.convertTo(picture.hasAlphaChannel() ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
    result.setColorSpace(QColorSpace()); // in this program sRGB pictures carry no colour space
    return result;
}

QImage inWide(const QImage& picture) {
    return isWide(picture) ? picture : converted(picture, QColorSpace::SRgb, wideSpace());
}

bool fitsInSrgb(const QImage& wide) {
    constexpr double step = 1.0 / 255;
    const double least = -step / 12.92; // sRGB's curve is a straight line near 0
    const double most = linearFromSrgb(1 + step);
    const std::vector<double>& light = lightTable();
    for (int row = 0; row < wide.height(); ++row) {
        const auto* pixel = reinterpret_cast<const quint16*>(wide.constScanLine(row));
        for (int column = 0; column < wide.width(); ++column, pixel += 4) {
            for (const std::array<double, 3>& weights : wideToSrgbLight) {
                const double channel = weights[0] * light[pixel[0]] + weights[1] * light[pixel[1]] +
                                       weights[2] * light[pixel[2]];
                if (channel < least || channel > most) {
                    return false;
                }
            }
        }
    }
    return true;
}

} // namespace dipwright

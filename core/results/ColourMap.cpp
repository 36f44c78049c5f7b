// Defines colour maps as curves in OKLab (B. Ottosson, "A perceptual color space for image
// processing", 2020). Lightness changes evenly. Equal steps of the value therefore look equal, and
// the order of values is visible in grey and with any colour vision.
#include "results/ColourMap.h"
#include "results/Results.h"
#include "texture/LinearLight.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Results)
};

struct OkLab {
    double lightness, a, b;
};

OkLab okLab(double lightness, double chroma, double hueDegrees) {
    const double hue = hueDegrees * pi / 180;
    return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

LinearColour linearColour(const OkLab& colour) {
    const auto cubed = [](double x) { return x * x * x; };
    const double l = cubed(colour.lightness + 0.3963377774 * colour.a + 0.2158037573 * colour.b);
    const double m = cubed(colour.lightness - 0.1055613458 * colour.a - 0.0638541728 * colour.b);
    const double s = cubed(colour.lightness - 0.0894841775 * colour.a - 1.2914855480 * colour.b);
    return {float(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            float(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            float(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

bool isInGamut(const LinearColour& colour) {
    return (colour >= -1e-4f).all() && (colour <= 1 + 1e-4f).all();
}

// Reduces the chroma until sRGB can show the colour at its lightness.
QColor shown(OkLab colour) {
    LinearColour linear = linearColour(colour);
    while (!isInGamut(linear)) {
        colour.a *= 0.98;
        colour.b *= 0.98;
        linear = linearColour(colour);
    }
    return {encodedByte(linear[0]), encodedByte(linear[1]), encodedByte(linear[2])};
}

double between(double from, double to, double share) {
    return from + (to - from) * share;
}

OkLab lagoon(double value) {
    return okLab(between(0.24, 0.93, value), between(0.11, 0.17, value), between(285, 103, value));
}

OkLab dusk(double value) {
    return {between(0.24, 0.93, value), between(-0.01, 0, value), between(-0.13, 0.15, value)};
}

OkLab balance(double value) {
    const double away = 2 * value - 1; // −1 … 1
    const double size = std::abs(away);
    return okLab(between(0.96, 0.44, size), 0.19 * std::pow(size, 0.8), away < 0 ? 255 : 48);
}

OkLab grey(double value) {
    return {between(0.2, 0.96, value), 0, 0};
}

struct NamedMap {
    const char* name;
    OkLab (*colour)(double);
    QRgb above;
};
constexpr NamedMap maps[] = {{"lagoon", lagoon, 0xffc00000},
                             {"dusk", dusk, 0xffc000e0},
                             {"balance", balance, 0xff000000},
                             {"grey", grey, 0xffc000e0}};

const NamedMap& mapOf(const QString& name) {
    const auto* found = std::find_if(std::begin(maps), std::end(maps), [&](const NamedMap& known) {
        return name == QLatin1String(known.name);
    });
    if (found == std::end(maps)) {
        throw Error(Text::tr("There is no colour map of this name; choose one of %1")
                        .arg(colourMaps().join(QStringLiteral(", "))),
                    name);
    }
    return *found;
}

} // namespace

QStringList colourMaps() {
    QStringList names;
    for (const NamedMap& map : maps) {
        names << QString::fromLatin1(map.name);
    }
    return names;
}

QColor mapColour(const QString& map, double value) {
    return shown(mapOf(map).colour(std::clamp(value, 0.0, 1.0)));
}

QColor colourAbove(const QString& map) {
    return QColor(mapOf(map).above);
}

QColor painterColour(Painter painter) {
    switch (painter) {
    case Painter::None:
        return {244, 247, 250};
    case Painter::First:
        return mapColour(QStringLiteral("balance"), 0.15);
    case Painter::Second:
        return mapColour(QStringLiteral("balance"), 0.85);
    case Painter::Both:
        return {52, 56, 62};
    }
    return {};
}

} // namespace dipwright

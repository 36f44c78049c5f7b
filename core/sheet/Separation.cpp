#include "sheet/Separation.h"

#include "parallel/ParallelFor.h"
#include "sheet/InkDistance.h"
#include "sheet/PrinterColour.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

void limitInk(QByteArray& cmyk, double mostInk) {
    const int most = int(std::floor(mostInk * 255));
    auto* const pixels = reinterpret_cast<uchar*>(cmyk.data());
    parallelFor(0, int(cmyk.size() / 4), [&](int pixel) {
        uchar* const ink = pixels + qsizetype(pixel) * 4;
        const int colours = ink[0] + ink[1] + ink[2];
        if (colours + ink[3] <= most) {
            return;
        }
        ink[3] = uchar(std::min<int>(ink[3], most));
        for (int channel = 0; channel < 3 && colours > 0; ++channel) {
            ink[channel] = uchar(ink[channel] * (most - ink[3]) / colours); // rounded down
        }
    });
}

QImage choked(const QImage& tint, double choke) {
    if (choke <= 0) {
        return tint;
    }
    const auto width = std::size_t(tint.width());
    std::vector<unsigned char> bare(width * std::size_t(tint.height()));
    for (int y = 0; y < tint.height(); ++y) {
        const uchar* row = tint.constScanLine(y);
        std::transform(row, row + width, bare.begin() + std::ptrdiff_t(width) * y,
                       [](uchar value) { return uchar(value == 0); });
    }
    const std::vector<float> distances = distancesTo(bare, tint.size());
    QImage smaller = tint;
    for (int y = 0; y < tint.height(); ++y) {
        uchar* row = smaller.scanLine(y);
        for (std::size_t x = 0; x < width; ++x) {
            // The bare place ends half a pixel from its middle.
            if (distances[std::size_t(y) * width + x] - 0.5 < choke) {
                row[x] = 0;
            }
        }
    }
    return smaller;
}

SpotPlates spotPlates(const Sheet& sheet) {
    SpotPlates plates;
    if (sheet.white.isNull()) {
        return plates;
    }
    SpotPlate white{sheet.settings.whiteName, {}};
    for (int y = 0; y < sheet.white.height(); ++y) {
        white.tint.append(reinterpret_cast<const char*>(sheet.white.constScanLine(y)),
                          sheet.white.width());
    }
    (sheet.settings.white == WhiteLayer::First ? plates.before : plates.after).push_back(white);
    return plates;
}

Plates separate(const QImage& filmImage, const PrintCorrection& correction) {
    Plates plates{filmImage.size(), correction.colour->cmyk(onPaper(filmImage))};
    if (correction.totalInk) {
        limitInk(plates.cmyk, *correction.totalInk);
    }
    return plates;
}

} // namespace dipwright

#include "sheet/Separation.h"

#include "parallel/ParallelFor.h"
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

Plates separate(const QImage& filmImage, const PrintCorrection& correction) {
    Plates plates{filmImage.size(), correction.colour->cmyk(onPaper(filmImage))};
    if (correction.totalInk) {
        limitInk(plates.cmyk, *correction.totalInk);
    }
    return plates;
}

} // namespace dipwright

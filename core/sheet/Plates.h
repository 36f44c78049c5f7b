// Pictures in inks, a plate an ink. Plain C++17, as what includes qpdf is built by some compilers.
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <vector>

namespace dipwright {

// One more plate beside cyan, magenta, yellow and black.
struct SpotPlate {
    QString name;    // as raster image processors know it
    QByteArray tint; // a byte a pixel, 0 no ink … 255 full, rows without padding
};

// What is printed beside the four inks, in the order of printing.
struct SpotPlates {
    std::vector<SpotPlate> before, after; // the four inks
};

struct Plates {
    QSize size;      // pixels, those of the picture
    QByteArray cmyk; // four bytes a pixel, 0 no ink … 255 full, rows without padding
};

} // namespace dipwright

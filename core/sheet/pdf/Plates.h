// Pictures in inks, a plate an ink. Plain C++17, as what includes qpdf is built by some compilers.
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <array>
#include <vector>

namespace dipwright {

// An ink beside cyan, magenta, yellow and black: white, varnish, a colour of its own, or what a
// cutter follows.
struct SpotInk {
    QString name; // as raster image processors know it
    // What stands for full ink of it where nobody knows the name: cyan, magenta, yellow, black, 0
    // … 1. None: nothing.
    std::array<double, 4> alternate{};
};

struct SpotPlate {
    SpotInk ink;
    bool first = false; // printed before the four inks, else after them
    QByteArray tint;    // a byte a pixel, 0 no ink … 255 full, rows without padding
};

struct Plates {
    QSize size;                   // pixels, those of the picture
    QByteArray cmyk;              // four bytes a pixel, 0 no ink … 255 full, rows without padding
    std::vector<SpotPlate> spots; // in the order of printing

    int channels() const { return 4 + int(spots.size()); }
};

} // namespace dipwright

// Holds a picture as one plate per ink. Plain C++17, because some compilers build the files that
// include qpdf as C++17.
#pragma once

#include "base/PackedPixels.h"

#include <QByteArray>
#include <QSize>
#include <QString>
#include <array>
#include <vector>

namespace dipwright {

// An ink besides cyan, magenta, yellow and black: white, varnish, another spot colour or a cutter's
// line.
struct SpotInk {
    QString name; // name that raster image processors know
    // Cyan, magenta, yellow and black, 0 … 1, that replace full ink where the name is unknown. All
    // 0: the ink is not shown there.
    std::array<double, 4> alternate{};
};

struct SpotPlate {
    SpotInk ink;
    bool first = false; // printed before the four inks, else after them
    QByteArray tint;    // one byte per pixel, 0 no ink … 255 full, rows without padding
};

struct Plates {
    QSize size;      // size of the picture, pixels
    QByteArray cmyk; // four bytes per pixel, 0 no ink … 255 full, rows without padding
    std::vector<SpotPlate> spots; // in printing order

    int channels() const { return 4 + int(spots.size()); }
};

// The same, compressed plate by plate. A picture of any length fits, because it is made row by row.
struct PackedPlates {
    struct Spot {
        SpotInk ink;
        bool first = false; // printed before the four inks, else after them
        PackedPixels tint;  // one byte per pixel
    };
    QSize size;              // size of the picture, pixels; empty: pages without a picture
    PackedPixels cmyk;       // four bytes per pixel
    std::vector<Spot> spots; // in printing order
};

} // namespace dipwright

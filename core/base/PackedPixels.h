// Rows of pixels packed as PNG and PDF take them.
#pragma once

#include <QByteArray>
#include <QImage>

#include <functional>
#include <vector>

namespace dipwright {

// A picture whose rows are made when their turn comes.
struct PixelRows {
    QSize size;
    int channels = 3;
    int bits = 8; // of a channel; 16: the upper byte first
    // Returns the rows first … end - 1, channels × bits a pixel. Called from several threads.
    std::function<QImage(int first, int end)> rows;
};

// A zlib stream (RFC 1950) in parts, of rows with PNG's filters (PDF: FlateDecode, predictor 15).
struct PackedPixels {
    QSize size;
    int channels = 3;
    int bits = 8;
    std::vector<QByteArray> parts;
};

// Packs on all cores, some rows at a time; the same bytes in every run. Throws std::bad_alloc.
PackedPixels packedPixels(const PixelRows& picture);

} // namespace dipwright

// Compresses rows of pixels in the form that PNG and PDF share.
#pragma once

#include <QByteArray>
#include <QImage>

#include <functional>
#include <vector>

namespace dipwright {

// A picture whose rows are made on demand.
struct PixelRows {
    QSize size;
    int channels = 3;
    int bits = 8; // per channel; 16 bits are big-endian
    // Returns the rows first … end - 1 with channels × bits per pixel. Called from several threads.
    std::function<QImage(int first, int end)> rows;
};

// A zlib stream (RFC 1950) in parts. The unpacked rows have PNG filters (in PDF: FlateDecode with
// predictor 15).
struct PackedPixels {
    QSize size;
    int channels = 3;
    int bits = 8;
    std::vector<QByteArray> parts;
};

// Compresses the picture in bands of rows, on all cores. The bytes are the same in every run.
// Throws std::bad_alloc.
PackedPixels packedPixels(const PixelRows& picture);

} // namespace dipwright

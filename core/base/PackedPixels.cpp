#include "base/PackedPixels.h"

#include "parallel/ParallelFor.h"

#include <QtEndian>

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace dipwright {
namespace {

constexpr qsizetype bandBytes = qsizetype(1) << 20; // bytes of pixels that are packed together
constexpr char paethFilter = 4;                     // Paeth's filter type in the file

// Appends a row after Paeth's filter: as differences from values predicted from the pixels to the
// left and above. See PNG specification, third edition, section 9.4. Both rows begin after one
// pixel of zeros.
void appendFiltered(std::vector<uchar>& filtered, const std::vector<uchar>& row,
                    const std::vector<uchar>& above, std::size_t pixelBytes) {
    filtered.push_back(paethFilter);
    const std::size_t begin = filtered.size();
    const std::size_t count = row.size() - pixelBytes;
    filtered.resize(begin + count);
    uchar* out = filtered.data() + begin;
    const uchar* left = row.data();
    const uchar* here = left + pixelBytes;
    const uchar* upperLeft = above.data();
    const uchar* upper = upperLeft + pixelBytes;
    for (std::size_t i = 0; i < count; ++i) {
        const int a = left[i], b = upper[i], c = upperLeft[i];
        const int fromA = std::abs(b - c), fromB = std::abs(a - c), fromC = std::abs(a + b - 2 * c);
        const int nearest = fromA <= fromB && fromA <= fromC ? a : fromB <= fromC ? b : c;
        out[i] = uchar(here[i] - nearest);
    }
}

std::vector<uchar> filteredRows(const PixelRows& picture, int begin, int end) {
    const std::size_t pixelBytes = std::size_t(picture.channels * picture.bits / 8);
    const std::size_t rowBytes = std::size_t(picture.size.width()) * pixelBytes;
    const int first = std::max(begin - 1, 0); // includes the row above, which the filter needs
    const QImage image = picture.rows(first, end);
    if (image.isNull()) {
        throw std::bad_alloc();
    }
    std::vector<uchar> filtered, row(pixelBytes + rowBytes, 0), above = row;
    filtered.reserve(std::size_t(end - begin) * (rowBytes + 1));
    if (begin > 0) {
        std::copy_n(image.constScanLine(0), rowBytes, row.data() + pixelBytes);
    }
    for (int y = begin; y < end; ++y) {
        row.swap(above);
        std::copy_n(image.constScanLine(y - first), rowBytes, row.data() + pixelBytes);
        appendFiltered(filtered, row, above, pixelBytes);
    }
    return filtered;
}

// A packed run of rows. More runs can follow in the same stream.
struct Band {
    QByteArray packed;
    std::size_t length = 0; // bytes before packing
    uLong checksum = 0;     // of the unpacked bytes
};

// Filtered rows consist mainly of runs and small numbers. A search for other repetitions takes
// three times as long and saves only 10 % of the bytes.
Band packedBand(const std::vector<uchar>& rows, bool isLast) {
    z_stream stream{};
    constexpr int withoutHeader = -MAX_WBITS, usualMemory = 8;
    if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, withoutHeader, usualMemory, Z_RLE) !=
        Z_OK) {
        throw std::bad_alloc();
    }
    Band band;
    constexpr uLong endOfBand = 16; // bytes at the band's end, which deflateBound() does not count
    band.packed.resize(qsizetype(deflateBound(&stream, uLong(rows.size())) + endOfBand));
    stream.next_in = const_cast<Bytef*>(rows.data()); // zlib only reads it
    stream.avail_in = uInt(rows.size());
    stream.next_out = reinterpret_cast<Bytef*>(band.packed.data());
    stream.avail_out = uInt(band.packed.size());
    deflate(&stream, isLast ? Z_FINISH : Z_SYNC_FLUSH);
    band.packed.resize(qsizetype(stream.total_out));
    band.packed.squeeze(); // a blank band needs a thousandth of its bound
    deflateEnd(&stream);
    band.length = rows.size();
    band.checksum = adler32_z(adler32_z(0, nullptr, 0), rows.data(), rows.size());
    return band;
}

std::vector<Band> packedBands(const PixelRows& picture) {
    const qsizetype rowBytes =
        qsizetype(picture.size.width()) * picture.channels * picture.bits / 8;
    const int height = picture.size.height();
    const int rows = int(std::max<qsizetype>(bandBytes / rowBytes, 1));
    std::vector<Band> bands(std::size_t((height + rows - 1) / rows));
    parallelFor(std::size_t(0), bands.size(), [&](std::size_t band) {
        const int begin = int(band) * rows;
        const int end = std::min(begin + rows, height);
        bands[band] = packedBand(filteredRows(picture, begin, end), end == height);
    });
    return bands;
}

} // namespace

PackedPixels packedPixels(const PixelRows& picture) {
    std::vector<Band> bands = packedBands(picture);
    bands.front().packed.prepend("\x78\x01", 2);
    uLong checksum = bands.front().checksum;
    for (std::size_t band = 1; band < bands.size(); ++band) {
        checksum = adler32_combine(checksum, bands[band].checksum, z_off_t(bands[band].length));
    }
    const quint32 bigEndian = qToBigEndian(quint32(checksum));
    bands.back().packed.append(reinterpret_cast<const char*>(&bigEndian), sizeof bigEndian);
    PackedPixels packed{picture.size, picture.channels, picture.bits, {}};
    for (Band& band : bands) {
        packed.parts.push_back(std::move(band.packed));
    }
    return packed;
}

} // namespace dipwright

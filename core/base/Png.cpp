#include "base/Png.h"

#include "base/Bytes.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <QIODevice>
#include <QtEndian>

#include <zlib.h>

#include <cstdlib>
#include <new>
#include <vector>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Png)
};

constexpr qsizetype bandBytes = qsizetype(1) << 20; // of pixels that are compressed together
constexpr char paethFilter = 4;                     // its number in the file

void append(QByteArray& bytes, quint32 number) {
    const quint32 bigEndian = qToBigEndian(number);
    bytes.append(reinterpret_cast<const char*>(&bigEndian), sizeof bigEndian);
}

QByteArray chunk(QByteArrayView name, const QByteArray& contents) {
    QByteArray bytes;
    bytes.reserve(contents.size() + 12);
    append(bytes, quint32(contents.size()));
    bytes.append(name).append(contents);
    const auto* covered = reinterpret_cast<const Bytef*>(bytes.constData()) + 4;
    append(bytes, quint32(crc32_z(0, covered, std::size_t(bytes.size()) - 4)));
    return bytes;
}

QByteArray header(const QImage& image) {
    QByteArray bytes;
    append(bytes, quint32(image.width()));
    append(bytes, quint32(image.height()));
    const char bits = isWide(image) ? 16 : 8;
    const char colourType = image.hasAlphaChannel() ? 6 : 2;
    bytes.append(bits).append(colourType).append(3, '\0');
    return chunk("IHDR", bytes);
}

QByteArray colourProfile(const QColorSpace& space) {
    // without the length that Qt puts before it
    const QByteArray packed = qCompress(space.iccProfile()).mid(4);
    return chunk("iCCP", QByteArrayLiteral("ICC profile\0\0") + packed);
}

QByteArray resolution(const QImage& image) {
    QByteArray bytes;
    append(bytes, quint32(image.dotsPerMeterX()));
    append(bytes, quint32(image.dotsPerMeterY()));
    return chunk("pHYs", bytes.append('\1'));
}

// Empty if the picture has no colour note.
QByteArray colourText(const QString& note) {
    return note.isEmpty() ? QByteArray()
                          : chunk("tEXt", QByteArray(colourNoteKey) + '\0' + note.toLatin1());
}

// Appends a row as its differences from the prediction of Paeth's filter, which uses the pixels to
// the left and above (PNG specification, third edition, section 9.4). Both rows begin with one
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

std::vector<uchar> filteredRows(const QImage& image, int begin, int end) {
    const std::size_t pixelBytes = std::size_t(image.depth()) / 8;
    const std::size_t rowBytes = std::size_t(image.width()) * pixelBytes;
    std::vector<uchar> filtered, row(pixelBytes + rowBytes, 0), above = row;
    filtered.reserve(std::size_t(end - begin) * (rowBytes + 1));
    if (begin > 0) {
        std::copy_n(image.constScanLine(begin - 1), rowBytes, row.data() + pixelBytes);
    }
    for (int y = begin; y < end; ++y) {
        row.swap(above);
        std::copy_n(image.constScanLine(y), rowBytes, row.data() + pixelBytes);
        appendFiltered(filtered, row, above, pixelBytes);
    }
    return filtered;
}

// A run of rows, compressed so that others can follow it.
struct Band {
    QByteArray packed;
    std::size_t length = 0; // uncompressed
    uLong checksum = 0;     // of the uncompressed bytes
};

// Filtered rows hold mostly runs and small numbers. Searching for other matches takes three times
// as long and saves only a tenth.
Band packedBand(const std::vector<uchar>& rows, bool isLast) {
    z_stream stream{};
    constexpr int withoutHeader = -MAX_WBITS, usualMemory = 8;
    if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, withoutHeader, usualMemory, Z_RLE) !=
        Z_OK) {
        throw std::bad_alloc();
    }
    Band band;
    constexpr uLong endOfBand = 16; // bytes that deflateBound() does not count
    band.packed.resize(qsizetype(deflateBound(&stream, uLong(rows.size())) + endOfBand));
    stream.next_in = const_cast<Bytef*>(rows.data()); // zlib only reads it
    stream.avail_in = uInt(rows.size());
    stream.next_out = reinterpret_cast<Bytef*>(band.packed.data());
    stream.avail_out = uInt(band.packed.size());
    deflate(&stream, isLast ? Z_FINISH : Z_SYNC_FLUSH);
    band.packed.resize(qsizetype(stream.total_out));
    deflateEnd(&stream);
    band.length = rows.size();
    band.checksum = adler32_z(adler32_z(0, nullptr, 0), rows.data(), rows.size());
    return band;
}

std::vector<Band> packedBands(const QImage& image) {
    const int rows = int(std::max<qsizetype>(bandBytes / image.bytesPerLine(), 1));
    std::vector<Band> bands(std::size_t((image.height() + rows - 1) / rows));
    parallelFor(std::size_t(0), bands.size(), [&](std::size_t band) {
        const int begin = int(band) * rows;
        const int end = std::min(begin + rows, image.height());
        bands[band] = packedBand(filteredRows(image, begin, end), end == image.height());
    });
    return bands;
}

// Joins the bands into a single zlib stream (RFC 1950), with one IDAT chunk for each band.
QByteArray pixels(const QImage& image) {
    std::vector<Band> bands = packedBands(image);
    bands.front().packed.prepend("\x78\x01", 2);
    uLong checksum = bands.front().checksum;
    for (std::size_t band = 1; band < bands.size(); ++band) {
        checksum = adler32_combine(checksum, bands[band].checksum, z_off_t(bands[band].length));
    }
    append(bands.back().packed, quint32(checksum));
    QByteArray bytes;
    for (const Band& band : bands) {
        bytes.append(chunk("IDAT", band.packed));
    }
    return bytes;
}

// Converts a wide picture's channels to the file's byte order, big-endian.
QImage bigEndian(const QImage& wide) {
    QImage turned = wide.convertToFormat(QImage::Format_RGBA64);
    for (int y = 0; y < turned.height(); ++y) {
        auto* row = reinterpret_cast<quint16*>(turned.scanLine(y));
        qToBigEndian<quint16>(row, qsizetype(turned.width()) * 4, row);
    }
    return turned;
}

} // namespace

QByteArray pngBytes(const QImage& image, const QString& where) {
    const QImage plain =
        isWide(image) ? bigEndian(image)
                      : image.convertToFormat(image.hasAlphaChannel() ? QImage::Format_RGBA8888
                                                                      : QImage::Format_RGB888);
    if (plain.isNull()) {
        throw Error(Text::tr("The picture cannot be stored as PNG, because it is empty or too "
                             "large for this computer's memory"),
                    where);
    }
    QByteArray bytes = QByteArrayLiteral("\x89PNG\r\n\x1a\n") + header(plain);
    if (plain.colorSpace().isValid()) {
        bytes += colourProfile(plain.colorSpace());
    }
    return bytes + resolution(plain) + colourText(colourNoteValue(image)) + pixels(plain) +
           chunk("IEND", QByteArray());
}

void writePng(const QImage& image, QIODevice& device, const QString& where) {
    const QByteArray bytes = pngBytes(image, where);
    if (device.write(bytes) != bytes.size()) {
        throw Error(Text::tr("The picture cannot be stored as PNG: %1").arg(device.errorString()),
                    where);
    }
}

} // namespace dipwright

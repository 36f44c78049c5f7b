#include "import/sandboxed/PictureFile.h"

#include <QtEndian>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <webp/demux.h>

namespace dipwright {

namespace {

constexpr int jpegEnd = 0xd9;

bool standsAlone(int marker) {
    constexpr int temporary = 0x01, firstRestart = 0xd0;
    return marker == temporary || (marker >= firstRestart && marker <= jpegEnd);
}

bool isJpegCutOff(const QByteArray& file) {
    auto marker = nextJpegMarker(file, 0);
    while (marker && marker->kind != jpegEnd) {
        marker = nextJpegMarker(file, marker->end);
    }
    return !marker;
}

template <typename Number>
Number numberAt(const QByteArray& file, qsizetype at) {
    return qFromLittleEndian<Number>(file.constData() + at);
}

// Whether a BMP file is cut off. Some programs omit the padding of the last row to a multiple of
// four bytes.
bool isBmpCutOff(const QByteArray& file) {
    constexpr qsizetype fileHeader = 14, longHeader = 40, shortHeader = 12;
    if (file.size() < fileHeader + shortHeader) {
        return true;
    }
    const auto header = qint64(numberAt<quint32>(file, fileHeader));
    const bool isShort = header == shortHeader;
    if (!isShort && file.size() < fileHeader + longHeader) {
        return true;
    }
    constexpr quint32 withRuns8 = 1, withRuns4 = 2;
    const quint32 packing = isShort ? 0 : numberAt<quint32>(file, 30);
    if (packing == withRuns8 || packing == withRuns4) {
        return false; // its length cannot be known in advance
    }
    const qint64 width = isShort ? numberAt<quint16>(file, 18) : numberAt<qint32>(file, 18);
    const qint64 height = isShort ? numberAt<quint16>(file, 20) : numberAt<qint32>(file, 22);
    const qint64 rowBits = width * numberAt<quint16>(file, isShort ? 24 : 28);
    const qint64 begin = std::max(qint64(numberAt<quint32>(file, 10)), fileHeader + header);
    const qint64 gaplessRow = (rowBits + 7) / 8, row = (rowBits + 31) / 32 * 4;
    // A double, because the header may hold absurd numbers.
    const double rows = double(row) * double(std::abs(height) - 1);
    return double(begin + gaplessRow) + rows > double(file.size());
}

} // namespace

std::optional<JpegMarker> nextJpegMarker(const QByteArray& file, qsizetype at) {
    const auto byte = [&](qsizetype place) { return int(uchar(file[place])); };
    for (at = file.indexOf('\xff', at); at >= 0; at = file.indexOf('\xff', at)) {
        while (at < file.size() && byte(at) == 0xff) {
            ++at;
        }
        if (at == file.size()) {
            break;
        }
        const int kind = byte(at++);
        if (kind == 0) { // an escaped byte 0xff of the scan
            continue;
        }
        if (standsAlone(kind)) {
            return JpegMarker{kind, {}, at};
        }
        const qsizetype length = at + 2 <= file.size() ? byte(at) << 8 | byte(at + 1) : 0;
        if (length < 2 || length > file.size() - at) {
            break;
        }
        return JpegMarker{kind, file.mid(at + 2, length - 2), at + length};
    }
    return std::nullopt;
}

bool isCutOff(const QByteArray& file) {
    return file.startsWith("\xff\xd8") ? isJpegCutOff(file)
           : file.startsWith("BM")     ? isBmpCutOff(file)
                                       : false;
}

std::optional<QByteArray> pngChunk(const QByteArray& file, QByteArrayView kind, PngPlace place) {
    constexpr qsizetype signature = 8, header = 8, frame = 12; // bytes; frame: header and check
    for (qsizetype at = signature; at + frame <= file.size();) {
        const auto length = qsizetype(qFromBigEndian<quint32>(file.constData() + at));
        const QByteArrayView found(file.constData() + at + 4, 4);
        if (length > file.size() - at - frame ||
            (found == "IDAT" && place == PngPlace::BeforePixels)) {
            break;
        }
        if (found == kind) {
            return file.mid(at + header, length);
        }
        at += frame + length;
    }
    return std::nullopt;
}

std::optional<QByteArray> webpChunk(const QByteArray& file, const char* kind, quint32 flag) {
    const WebPData data{reinterpret_cast<const uchar*>(file.constData()), std::size_t(file.size())};
    const std::unique_ptr<WebPDemuxer, decltype(&WebPDemuxDelete)> webp(WebPDemux(&data),
                                                                        WebPDemuxDelete);
    if (!webp || (WebPDemuxGetI(webp.get(), WEBP_FF_FORMAT_FLAGS) & flag) == 0) {
        return std::nullopt; // Qt refuses damaged files later, with the same library
    }
    WebPChunkIterator found;
    if (WebPDemuxGetChunk(webp.get(), kind, 1, &found) == 0) {
        return QByteArray();
    }
    return QByteArray(reinterpret_cast<const char*>(found.chunk.bytes),
                      qsizetype(found.chunk.size));
}

QByteArray exifOf(const QByteArray& file) {
    constexpr QByteArrayView prefix("Exif\0\0",
                                    6); // in JPEG; some programs write it elsewhere, too
    QByteArray exif;
    if (file.startsWith("II") || file.startsWith("MM")) {
        return file;
    }
    if (file.startsWith("\x89PNG")) {
        exif = pngChunk(file, "eXIf", PngPlace::Anywhere).value_or(QByteArray());
    } else if (file.startsWith("RIFF")) {
        exif = webpChunk(file, "EXIF", EXIF_FLAG).value_or(QByteArray());
    } else if (file.startsWith("\xff\xd8")) {
        auto marker = nextJpegMarker(file, 0);
        while (marker && marker->kind != jpegScan &&
               !(marker->kind == 0xe1 && marker->segment.startsWith(prefix))) {
            marker = nextJpegMarker(file, marker->end);
        }
        exif = marker && marker->kind != jpegScan ? marker->segment : QByteArray();
    }
    return exif.startsWith(prefix) ? exif.mid(prefix.size()) : exif;
}

bool namesUnreadSpace(const QByteArray& file) {
    constexpr QByteArrayView sRgb("\x01\x0d", 2); // primaries and transfer function
    const auto chunk = file.startsWith("\x89PNG") ? pngChunk(file, "cICP") : std::nullopt;
    return chunk && !chunk->startsWith(sRgb);
}

} // namespace dipwright

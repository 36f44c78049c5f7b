#include "base/Png.h"

#include "base/Bytes.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/ImageRows.h"
#include "base/InkPicture.h"
#include "base/WideGamut.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <QIODevice>
#include <QtEndian>

#include <zlib.h>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Png)
};

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

QByteArray header(const PackedPixels& pixels) {
    QByteArray bytes;
    append(bytes, quint32(pixels.size.width()));
    append(bytes, quint32(pixels.size.height()));
    const char colourType = pixels.channels == 4 ? 6 : 2;
    bytes.append(char(pixels.bits)).append(colourType).append(3, '\0');
    return chunk("IHDR", bytes);
}

QByteArray colourProfile(const QColorSpace& space) {
    // without the length that qCompress() puts first
    const QByteArray packed = qCompress(space.iccProfile()).mid(4);
    return chunk("iCCP", QByteArrayLiteral("ICC profile\0\0") + packed);
}

QByteArray resolution(const PngNotes& notes) {
    QByteArray bytes;
    append(bytes, quint32(notes.dotsPerMetreX));
    append(bytes, quint32(notes.dotsPerMetreY));
    return chunk("pHYs", bytes.append('\1'));
}

// Returns the file's chunk for a text; empty if the text is empty.
QByteArray text(const char* key, const QString& value) {
    return value.isEmpty() ? QByteArray()
                           : chunk("tEXt", QByteArray(key) + '\0' + value.toLatin1());
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

QByteArray pngBytes(const PackedPixels& pixels, const PngNotes& notes) {
    QByteArray bytes = QByteArrayLiteral("\x89PNG\r\n\x1a\n") + header(pixels);
    if (notes.colours.isValid()) {
        bytes += colourProfile(notes.colours);
    }
    bytes += resolution(notes) + text(colourNoteKey, notes.colourNote) +
             text(inkSpaceKey, notes.inkSpace);
    for (const QByteArray& part : pixels.parts) {
        bytes += chunk("IDAT", part);
    }
    return bytes + chunk("IEND", QByteArray());
}

QByteArray pngBytes(const QImage& image, const QString& where) {
    if (image.isNull()) {
        throw Error(Text::tr("The picture cannot be stored as PNG, because it is empty or too "
                             "large for this computer's memory"),
                    where);
    }
    const bool wide = isWide(image);
    const int channels = wide || image.hasAlphaChannel() ? 4 : 3;
    const auto rows = [&](int first, int end) {
        const QImage part = imageRows(image, first, end);
        return wide ? bigEndian(part)
                    : part.convertToFormat(channels == 4 ? QImage::Format_RGBA8888
                                                         : QImage::Format_RGB888);
    };
    return pngBytes(packedPixels({image.size(), channels, wide ? 16 : 8, rows}),
                    {image.dotsPerMeterX(), image.dotsPerMeterY(), image.colorSpace(),
                     colourNoteValue(image), inkSpace(image)});
}

void writePng(const QImage& image, QIODevice& device, const QString& where) {
    writeTo(device, pngBytes(image, where), Text::tr("The picture cannot be stored as PNG: %1"),
            where);
}

} // namespace dipwright

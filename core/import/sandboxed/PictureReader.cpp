#include "import/sandboxed/PictureReader.h"

#include "base/Budgets.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "import/sandboxed/PictureColour.h"
#include "import/sandboxed/PictureFile.h"

#include <QBuffer>
#include <QColorSpace>
#include <QCoreApplication>
#include <QImageReader>

#include <cmath>
#include <new>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Texture)
};

// A picture that only states a gamma near 2.2 means sRGB, as every program shows it.
bool isAsGoodAsSRgb(const QColorSpace& space) {
    return !space.isValid() || space == QColorSpace::SRgb ||
           (space.primaries() == QColorSpace::Primaries::SRgb &&
            space.transferFunction() == QColorSpace::TransferFunction::Gamma &&
            std::abs(space.gamma() - 2.2F) < 0.05F);
}

// `profile`: what the file says of its numbers, which Qt reads of RGB only; may be empty.
QImage asTexture(QImage image, const QByteArray& profile, const QString& where,
                 PictureReader::Turned turned) {
    if (!profile.isEmpty() && image.colorSpace() != QColorSpace(QColorSpace::SRgb)) {
        return turned == PictureReader::Turned::Upright ? srgbOf(image, profile, where)
                                                        : textureOf(image, profile, where);
    }
    if (!isAsGoodAsSRgb(image.colorSpace())) {
        image.convertToColorSpace(QColorSpace::SRgb);
    }
    image.convertTo(QImage::Format_RGBA8888);
    if (image.isNull()) {
        throw std::bad_alloc();
    }
    image.setColorSpace(QColorSpace());
    return image;
}

const QByteArray heif = "heif"; // that Qt reads where a plugin for it is installed

// Qt's name for the format, by the first bytes; empty for all that is not read. A name in a model
// says nothing: an SVG called .png would draw what it likes, from wherever it likes.
QByteArray formatOf(const QByteArray& bytes) {
    if (bytes.startsWith("\x89PNG\r\n\x1a\n")) {
        return "png";
    }
    if (bytes.startsWith("\xff\xd8\xff")) {
        return "jpeg";
    }
    if (bytes.startsWith("BM")) {
        return "bmp";
    }
    if (bytes.startsWith(QByteArrayView("II*\0", 4)) ||
        bytes.startsWith(QByteArrayView("MM\0*", 4))) {
        return "tiff";
    }
    if (bytes.startsWith("RIFF") && bytes.mid(8, 4) == "WEBP") {
        return "webp";
    }
    const QByteArray brand = bytes.mid(8, 4);
    return bytes.mid(4, 4) == "ftyp" && (brand.startsWith("hei") || brand == "mif1") ? heif
                                                                                     : QByteArray();
}

void requireWhole(const QByteArray& bytes, const QString& where, PictureReader::Turned turned) {
    if (!isCutOff(bytes)) {
        return;
    }
    throw Error(turned == PictureReader::Turned::Upright
                    ? Text::tr("The photo is cut off in the middle; copy it from the camera "
                               "again")
                    : Text::tr("The picture is cut off before its end; save it anew, or copy it "
                               "again from where it came"),
                where);
}

} // namespace

void PictureReader::prepare() {
    QImageReader::supportedImageFormats();
}

void PictureReader::count(const QSize& size, qint64 fileBytes, const QString& where) {
    if (size.isEmpty()) {
        throw Error(Text::tr("The picture has no pixels; choose another one"), where);
    }
    const QString place =
        Text::tr("%1, with %2 × %3 pixels").arg(where).arg(size.width()).arg(size.height());
    requireWithin(Budget::PictureSide, std::max(size.width(), size.height()), place);
    pixels_ += qint64(size.width()) * size.height();
    fileBytes_ += fileBytes;
    requireWithin(Budget::Pixels, pixels_, place, fileBytes_);
}

QImage PictureReader::read(const QByteArray& bytes, const QString& where, Turned turned) {
    // Qt's own limit refuses 8192 × 8192; ours is the size checked before anything is decoded.
    constexpr int mostBytesPerPixel = 8;
    QImageReader::setAllocationLimit(
        int(mostOf(Budget::Pixels, bytes.size()) * mostBytesPerPixel >> 20));
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    const QByteArray format = formatOf(bytes);
    QImageReader reader;
    reader.setAutoDetectImageFormat(false);
    reader.setAutoTransform(turned == Turned::Upright);
    reader.setFormat(format);
    reader.setDevice(&buffer);
    if (format == heif && !reader.canRead()) {
        throw Error(Text::tr("Pictures in HEIF are not read here; save it as JPEG, or let the "
                             "camera write JPEG"),
                    where);
    }
    if (format.isEmpty() || !reader.canRead()) {
        throw Error(Text::tr("The file is not a picture that can be read; save it as PNG or JPEG"),
                    where);
    }
    const QSize announced = reader.size();
    if (announced.isValid()) {
        count(announced, bytes.size(), where);
    }
    requireWhole(bytes, where, turned);
    if (isOfLab(bytes)) { // Qt would take it for RGB
        const QImage texture = readInLab(bytes, announced, where);
        return turned == Turned::Upright ? inSrgb(texture) : texture;
    }
    const QByteArray profile = embeddedProfile(bytes, where);
    if (!profile.isEmpty() && turned == Turned::AsStored) { // photos are looked at, not printed
        if (const auto inks = readInks(bytes)) {
            if (!announced.isValid()) {
                count(inks->size, bytes.size(), where);
            }
            return textureOf(*inks, profile, where);
        }
        if (isOfInks(profile) && (format == "jpeg" || format == "tiff")) {
            throw Error(Text::tr("The picture in CMYK is damaged, or kept in a way that is not "
                                 "read; save it anew as JPEG, or as TIFF without tiles and planes"),
                        where);
        }
    }
    QImage image = reader.read();
    if (image.isNull()) {
        throw Error(Text::tr("The picture is damaged: %1; save it anew").arg(reader.errorString()),
                    where);
    }
    if (!announced.isValid()) {
        count(image.size(), bytes.size(), where);
    }
    const bool assumesInks = profile.isEmpty() && turned == Turned::AsStored && readInks(bytes);
    image = asTexture(std::move(image), profile, where, turned);
    return assumesInks ? withColourNote(image, {.assumesInks = true}) : image;
}

// `announced`: by Qt; not valid where it does not say.
QImage PictureReader::readInLab(const QByteArray& bytes, const QSize& announced,
                                const QString& where) {
    const auto lab = readLab(bytes);
    if (!lab) {
        throw Error(Text::tr("The picture in Lab is damaged, or kept in a way that is not read; "
                             "save it anew as RGB, or as TIFF in 8 or 16 bits without tiles and "
                             "planes"),
                    where);
    }
    if (!announced.isValid()) {
        count(lab->size, bytes.size(), where);
    }
    return textureOf(*lab, where);
}

QImage PictureReader::take(QImage image, const QString& where) {
    count(image.size(), image.sizeInBytes(), where);
    return asTexture(std::move(image), {}, where, Turned::AsStored);
}

} // namespace dipwright

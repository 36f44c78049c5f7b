#include "import/sandboxed/PictureReader.h"

#include "base/Budgets.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/InkPicture.h"
#include "base/WideGamut.h"
#include "import/sandboxed/PhotoFacts.h"
#include "import/sandboxed/PictureColour.h"
#include "import/sandboxed/PictureFile.h"

#include <QBuffer>
#include <QColorSpace>
#include <QCoreApplication>
#include <QImageReader>
#include <QTransform>

#include <array>
#include <cmath>
#include <new>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Texture)
};

// Whether the space counts as sRGB. Every program shows a picture that only states a gamma near 2.2
// as sRGB.
bool isAsGoodAsSRgb(const QColorSpace& space) {
    return !space.isValid() || space == QColorSpace::SRgb ||
           (space.primaries() == QColorSpace::Primaries::SRgb &&
            space.transferFunction() == QColorSpace::TransferFunction::Gamma &&
            std::abs(space.gamma() - 2.2F) < 0.05F);
}

// Returns the same numbers as RGBA8888 without a colour space.
QImage inRgba(QImage image) {
    image.convertTo(QImage::Format_RGBA8888);
    if (image.isNull()) {
        throw std::bad_alloc();
    }
    image.setColorSpace(QColorSpace());
    return image;
}

// Converts a decoded picture. `profile` is the file's ICC profile, which Qt reads for RGB only; may
// be empty.
QImage asTexture(QImage image, const QByteArray& profile, const QString& where,
                 PictureReader::Turned turned) {
    if (!profile.isEmpty() && image.colorSpace() != QColorSpace(QColorSpace::SRgb)) {
        return turned == PictureReader::Turned::Upright ? srgbOf(image, profile, where)
                                                        : textureOf(image, profile, where);
    }
    if (!isAsGoodAsSRgb(image.colorSpace())) {
        image.convertToColorSpace(QColorSpace::SRgb);
    }
    return inRgba(std::move(image));
}

const QByteArray heif = "heif"; // Qt reads it if a plugin is installed

// Returns Qt's name for the format from the first bytes; empty for formats that are not supported.
// The file name cannot be trusted: an SVG named .png could load and draw other files.
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

// Returns how the EXIF data of a PNG or WebP file says that it is to be shown. Qt follows that of
// the other formats only.
QImageIOHandler::Transformations turnThatQtIgnores(const QByteArray& bytes) {
    using Handler = QImageIOHandler;
    constexpr std::array turns{Handler::TransformationNone,
                               Handler::TransformationMirror,
                               Handler::TransformationRotate180,
                               Handler::TransformationFlip,
                               Handler::TransformationFlipAndRotate90,
                               Handler::TransformationRotate90,
                               Handler::TransformationMirrorAndRotate90,
                               Handler::TransformationRotate270};
    const QByteArray format = formatOf(bytes);
    return format == "png" || format == "webp" ? turns[std::size_t(exifOrientation(bytes) - 1)]
                                               : Handler::TransformationNone;
}

QImage shownAs(QImage picture, QImageIOHandler::Transformations turn) {
    if (turn == QImageIOHandler::TransformationNone) {
        return picture;
    }
    picture = picture.mirrored(turn.testFlag(QImageIOHandler::TransformationMirror),
                               turn.testFlag(QImageIOHandler::TransformationFlip));
    if (turn.testFlag(QImageIOHandler::TransformationRotate90)) {
        picture = picture.transformed(QTransform().rotate(90));
    }
    if (picture.isNull()) {
        throw std::bad_alloc();
    }
    return picture;
}

// Whether the file says that the picture is to be shown turned or mirrored.
bool isStoredTurned(const QByteArray& bytes) {
    if (turnThatQtIgnores(bytes) != QImageIOHandler::TransformationNone) {
        return true;
    }
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer, formatOf(bytes));
    return reader.transformation() != QImageIOHandler::TransformationNone;
}

// `format` is the reader's format.
void requireReadable(const QImageReader& reader, const QByteArray& format, const QString& where) {
    if (format == heif && !reader.canRead()) {
        throw Error(Text::tr("HEIF pictures cannot be read on this computer; save the picture as "
                             "JPEG, or set the camera to JPEG"),
                    where);
    }
    if (format.isEmpty() || !reader.canRead()) {
        throw Error(Text::tr("The file is not a picture that can be read; save it as PNG or JPEG"),
                    where);
    }
}

void requireReadableTiff(const QByteArray& bytes, const QString& where) {
    if (isMisreadTiff(bytes)) {
        throw Error(Text::tr("The TIFF file stores its pixels in a way that is not supported, such "
                             "as in planes, as floating-point numbers or with extra channels; "
                             "save the picture again as PNG, or as TIFF with 8 or 16 bits, without "
                             "planes and extra channels"),
                    where);
    }
}

void requireWhole(const QByteArray& bytes, const QString& where, PictureReader::Turned turned) {
    if (!isCutOff(bytes)) {
        return;
    }
    throw Error(turned == PictureReader::Turned::Upright
                    ? Text::tr("The photo is incomplete; copy it from the camera again")
                    : Text::tr("The picture file is incomplete; save it again, or copy it again "
                               "from its source"),
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
    QImage picture = decoded(bytes, where, turned);
    if (turned == Turned::Upright) {
        return shownAs(std::move(picture), turnThatQtIgnores(bytes));
    }
    ColourNote note = colourNote(picture);
    note.isTurned = note.isTurned || isStoredTurned(bytes);
    note.assumesSrgb = note.assumesSrgb || namesUnreadSpace(bytes);
    auto inks = inks_.extract(picture.cacheKey());
    if (!note.isEmpty()) {
        picture = withColourNote(std::move(picture), note);
    }
    if (inks) {
        inks.key() = picture.cacheKey();
        inks_.insert(std::move(inks));
    }
    return picture;
}

QImage PictureReader::decoded(const QByteArray& bytes, const QString& where, Turned turned) {
    // Qt's default limit would refuse 8192 × 8192. Instead, the size is checked before anything is
    // decoded.
    constexpr int mostBytesPerPixel = 8;
    QImageReader::setAllocationLimit(
        int(budgetLimit(Budget::Pixels, bytes.size()) * mostBytesPerPixel >> 20));
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    const QByteArray format = formatOf(bytes);
    QImageReader reader;
    reader.setAutoDetectImageFormat(false);
    reader.setAutoTransform(turned == Turned::Upright);
    reader.setFormat(format);
    reader.setDevice(&buffer);
    requireReadable(reader, format, where);
    const QSize announced = reader.size();
    if (announced.isValid()) {
        count(announced, bytes.size(), where);
    }
    requireWhole(bytes, where, turned);
    requireReadableTiff(bytes, where);
    if (isOfLab(bytes)) { // Qt would read it as RGB
        const QImage texture = readInLab(bytes, announced, where);
        return turned == Turned::Upright ? inSrgb(texture) : texture;
    }
    const QByteArray profile = embeddedProfile(bytes, where);
    if (!profile.isEmpty() && turned == Turned::AsStored) { // photos are viewed, not printed
        if (const auto inks = readInks(bytes)) {
            if (!announced.isValid()) {
                count(inks->size, bytes.size(), where);
            }
            const QImage texture = textureOf(*inks, profile, where);
            count(inks->size, 0, where); // the amounts are kept, too
            inks_[texture.cacheKey()] = inkPictureOf(*inks, profile);
            return texture;
        }
        if (isOfInks(profile) && (format == "jpeg" || format == "tiff")) {
            throw Error(Text::tr("The CMYK picture is damaged or stored in an unsupported way; "
                                 "save it again as JPEG, or as TIFF without tiles or planes"),
                        where);
        }
    }
    QImage image = reader.read();
    if (image.isNull() && profile.isEmpty() && readInks(bytes)) { // Qt reads 8 bits only
        throw Error(Text::tr("The CMYK picture has 16 bits and no ICC profile; save it with its "
                             "profile, with 8 bits, or as sRGB"),
                    where);
    }
    if (image.isNull()) {
        throw Error(Text::tr("The picture is damaged: %1; save it again").arg(reader.errorString()),
                    where);
    }
    if (!announced.isValid()) {
        count(image.size(), bytes.size(), where);
    }
    if (format == "png" && !inkSpace(image).isEmpty()) { // stored by this program
        return inRgba(std::move(image));
    }
    const bool assumesInks = profile.isEmpty() && turned == Turned::AsStored && readInks(bytes);
    image = asTexture(std::move(image), profile, where, turned);
    return assumesInks ? withColourNote(image, {.assumesInks = true}) : image;
}

// `announced` is the size that Qt reports; invalid if it reports none.
QImage PictureReader::readInLab(const QByteArray& bytes, const QSize& announced,
                                const QString& where) {
    const auto lab = readLab(bytes);
    if (!lab) {
        throw Error(Text::tr("The Lab picture is damaged or stored in an unsupported way; save it "
                             "again as RGB, or as TIFF in 8 or 16 bits without tiles or planes"),
                    where);
    }
    if (!announced.isValid()) {
        count(lab->size, bytes.size(), where);
    }
    return textureOf(*lab, where);
}

QImage PictureReader::inksOf(const QImage& picture) const {
    const auto found = inks_.find(picture.cacheKey());
    return found == inks_.end() ? QImage() : found->second;
}

QImage PictureReader::take(QImage image, const QString& where) {
    count(image.size(), image.sizeInBytes(), where);
    return asTexture(std::move(image), {}, where, Turned::AsStored);
}

} // namespace dipwright

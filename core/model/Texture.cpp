#include "model/Texture.h"

#include "base/Error.h"

#include <QBuffer>
#include <QColorSpace>
#include <QCoreApplication>
#include <QImageReader>

#include <cmath>

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

} // namespace

void checkTextureSize(const QSize& size, const QString& where) {
    if (size.isEmpty()) {
        throw Error(Text::tr("The texture has no pixels; choose another picture"), where);
    }
    if (size.width() > maximumTextureSide || size.height() > maximumTextureSide) {
        throw Error(Text::tr("The texture has %1 × %2 pixels; make it %3 pixels a side at the most")
                        .arg(size.width())
                        .arg(size.height())
                        .arg(maximumTextureSide),
                    where);
    }
}

QImage asTexture(QImage image) {
    if (!isAsGoodAsSRgb(image.colorSpace())) {
        image.convertToColorSpace(QColorSpace::SRgb);
    }
    image.convertTo(QImage::Format_RGBA8888);
    image.setColorSpace(QColorSpace());
    return image;
}

QImage readTexture(const QByteArray& bytes, const QString& where) {
    // Qt's own limit refuses 8192 × 8192; ours is the size checked before anything is decoded.
    constexpr int bytesPerPixel = 4;
    QImageReader::setAllocationLimit(
        int(qint64(maximumTextureSide) * maximumTextureSide * bytesPerPixel >> 20));
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer);
    reader.setDecideFormatFromContent(true);
    if (!reader.canRead()) {
        throw Error(
            Text::tr("The texture is not a picture that can be read; save it as PNG or JPEG"),
            where);
    }
    if (const QSize size = reader.size(); size.isValid()) {
        checkTextureSize(size, where);
    }
    QImage image = reader.read();
    if (image.isNull()) {
        throw Error(Text::tr("The texture is damaged: %1; save it anew").arg(reader.errorString()),
                    where);
    }
    checkTextureSize(image.size(), where);
    return asTexture(std::move(image));
}

} // namespace dipwright

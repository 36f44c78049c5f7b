#include "base/Png.h"

#include "base/Bytes.h"
#include "base/Error.h"

#include <QCoreApplication>
#include <QImageWriter>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Png)
};

constexpr int fastCompression = 20; // of 100

} // namespace

void writePng(const QImage& image, QIODevice& device, const QString& where, PngPacking packing) {
    QImageWriter writer(&device, "png");
    if (packing == PngPacking::Fast) {
        writer.setCompression(fastCompression);
    }
    if (!writer.write(image)) {
        throw Error(Text::tr("The picture cannot be stored as PNG: %1").arg(writer.errorString()),
                    where);
    }
}

QByteArray pngBytes(const QImage& image, const QString& where, PngPacking packing) {
    return bytesOf([&](QIODevice& device) { writePng(image, device, where, packing); });
}

} // namespace dipwright

// Pictures as PNG files.
#pragma once

#include <QByteArray>
#include <QImage>

class QIODevice;

namespace dipwright {

// Fast: half the time of Small, half again as many bytes.
enum class PngPacking { Small, Fast };

// Throws Error with Qt's reason where the picture cannot be packed or `device` takes no more;
// `where` is what the user knows the picture by.
void writePng(const QImage& image, QIODevice& device, const QString& where,
              PngPacking packing = PngPacking::Small);
QByteArray pngBytes(const QImage& image, const QString& where,
                    PngPacking packing = PngPacking::Small);

} // namespace dipwright

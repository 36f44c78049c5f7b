// Writes pictures as PNG files.
#pragma once

#include <QByteArray>
#include <QImage>

class QIODevice;

namespace dipwright {

// Writes eight bits per channel, sixteen for a wide picture, with colour space and resolution.
// Compresses on all cores; the bytes are the same in every run. Throws Error if the picture is
// empty, memory does not suffice or `device` cannot be written. `where` is the name by which the
// user knows the picture.
void writePng(const QImage& image, QIODevice& device, const QString& where);
QByteArray pngBytes(const QImage& image, const QString& where);

} // namespace dipwright

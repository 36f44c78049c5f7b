// Pictures as PNG files.
#pragma once

#include "base/PackedPixels.h"

#include <QByteArray>
#include <QColorSpace>
#include <QImage>

class QIODevice;

namespace dipwright {

// With eight bits a channel, a wide picture with sixteen, colour space and resolution. Packed on
// all cores, the same bytes in every run. Throws Error where there is no picture or no memory for
// it, or where `device` takes no more; `where` is what the user knows the picture by.
void writePng(const QImage& image, QIODevice& device, const QString& where);
QByteArray pngBytes(const QImage& image, const QString& where);

// What a PNG file says beside its pixels.
struct PngNotes {
    int dotsPerMetreX = 0, dotsPerMetreY = 0;
    QColorSpace colours = {}; // invalid: none
    QString colourNote = {};  // base/ColourNote.h
};
// A file of pixels packed already: RGB or RGBA.
QByteArray pngBytes(const PackedPixels& pixels, const PngNotes& notes);

} // namespace dipwright

// Writes pictures as PNG files.
#pragma once

#include "base/PackedPixels.h"

#include <QByteArray>
#include <QColorSpace>
#include <QImage>

class QIODevice;

namespace dipwright {

// Writes a picture with its colour space and resolution: eight bits per channel, sixteen for a wide
// picture. Compresses on all cores; the bytes are the same in every run. Throws Error if the
// picture is empty, memory does not suffice or `device` cannot be written. `where` is the name by
// which the user knows the picture.
void writePng(const QImage& image, QIODevice& device, const QString& where);
QByteArray pngBytes(const QImage& image, const QString& where);

// The metadata of a PNG file.
struct PngNotes {
    int dotsPerMetreX = 0, dotsPerMetreY = 0;
    QColorSpace colours = {}; // invalid if the file names no colour space
    QString colourNote = {};  // see base/ColourNote.h; empty if there is no note
    QString inkSpace = {};    // see base/InkPicture.h; empty for pictures of colours
};
// Returns a PNG file of compressed pixels, RGB or RGBA.
QByteArray pngBytes(const PackedPixels& pixels, const PngNotes& notes);

} // namespace dipwright

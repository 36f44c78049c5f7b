// Pictures from files that nobody has looked at yet. Private to this folder.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

namespace dipwright {

inline constexpr int maximumTextureSide = 32768; // pixels

// Decodes a picture to RGBA8888 in sRGB. Throws Error, naming `where`, for what is no picture, has
// no pixels or is larger than maximumTextureSide; nothing is decoded before its size is known to
// do.
QImage readTexture(const QByteArray& bytes, const QString& where);

// Throws Error for a picture without pixels or with more than maximumTextureSide a side.
void checkTextureSize(const QSize& size, const QString& where);

// Brings a picture to RGBA8888 in sRGB.
QImage asTexture(QImage image);

} // namespace dipwright

// Colours of pictures that say what their numbers mean: by an ICC profile, grey, RGB and CMYK; by
// themselves, CIE L*a*b*.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <array>
#include <optional>
#include <vector>

namespace dipwright {

// The ICC profile in a PNG, JPEG, TIFF or WebP file; empty where there is none. Throws Error,
// naming `where`, for a file that says it has one which is damaged, not whole or beyond all
// measure.
QByteArray embeddedProfile(const QByteArray& file, const QString& where);

// Pixels in four inks, row by row without gaps: cyan, magenta, yellow, black, 0 none … 65535 full.
struct InkPicture {
    QSize size;
    std::vector<std::array<quint16, 4>> inks;
};

bool isOfInks(const QByteArray& profile); // of CMYK, by its header

// The pixels of a JPEG or TIFF file that holds CMYK (or YCCK); none for any other file, and for one
// that is damaged or kept in a way that is not read (tiles, planes).
std::optional<InkPicture> readInks(const QByteArray& file);

// Pixels in CIE L*a*b* (D50), row by row without gaps: L* 0 … 100, a* and b*.
struct LabPicture {
    QSize size;
    std::vector<std::array<float, 3>> colours;
};

bool isOfLab(const QByteArray& file); // a TIFF file in CIE L*a*b*, as it says
// Its pixels; none where it is damaged or kept in a way that is not read: tiles, planes, other bits
// than 8 or 16.
std::optional<LabPicture> readLab(const QByteArray& file);

// As textures have them, by lcms2, relative to white: RGBA8888 in sRGB where that holds the
// colours, else wide (base/WideGamut.h). `profile` is that of the picture's own space: CMYK for
// inks; grey or RGB for an image, whose own idea of its colour space is not asked. All throw Error,
// naming `where`, for a profile that is damaged or of another kind than the pixels. Where colours
// lie visibly beyond wide's primaries, the texture has a note of how many (base/ColourNote.h).
QImage textureOf(const LabPicture& picture, const QString& where);
QImage textureOf(const InkPicture& picture, const QByteArray& profile, const QString& where);
QImage textureOf(const QImage& picture, const QByteArray& profile, const QString& where);
// RGBA8888 in sRGB, what that cannot show at its nearest there.
QImage srgbOf(const QImage& picture, const QByteArray& profile, const QString& where);

} // namespace dipwright

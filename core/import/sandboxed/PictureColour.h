// Converts the colours of pictures with a defined colour space: grey, RGB and CMYK with an ICC
// profile, and CIE L*a*b*.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <array>
#include <optional>
#include <vector>

namespace dipwright {

// Returns the ICC profile in a PNG, JPEG, TIFF or WebP file; empty if there is none. Throws Error,
// naming `where`, if the profile is damaged, incomplete or far too large.
QByteArray embeddedProfile(const QByteArray& file, const QString& where);

// Whether a file is TIFF that the decoders here would read wrongly. Qt reads the first plane of
// 16-bit planes only, and drops or misreads channels that are not one transparency beside RGB.
bool isMisreadTiff(const QByteArray& file);

// Pixels in four inks, row by row without gaps: cyan, magenta, yellow, black; 0 is no ink, 65535
// full ink.
struct InkPicture {
    QSize size;
    std::vector<std::array<quint16, 4>> inks;
};

// Returns the picture as amounts in eight bits (base/InkPicture.h). `profile` is that of its inks.
QImage inkPictureOf(const InkPicture& picture, const QByteArray& profile);

bool isOfInks(const QByteArray& profile); // whether the profile's header says that it is for CMYK

// Returns the pixels of a JPEG or TIFF file in CMYK (or YCCK). Returns nothing for any other file,
// and for a file that is damaged or stored in an unsupported way (tiles, planes).
std::optional<InkPicture> readInks(const QByteArray& file);

// Pixels in CIE L*a*b* (D50), row by row without gaps: L* 0 … 100, a* and b*.
struct LabPicture {
    QSize size;
    std::vector<std::array<float, 3>> colours;
};

bool isOfLab(const QByteArray& file); // whether a file's tags say that it is TIFF in CIE L*a*b*
// Returns the pixels of such a file. Returns nothing if the file is damaged or stored in an
// unsupported way: tiles, planes, or not 8 or 16 bits.
std::optional<LabPicture> readLab(const QByteArray& file);

// Converts to a texture by lcms2, relative colorimetric. For inks with black point compensation, as
// for printing (PrinterColour.h), so that dark tones come back as they were. The texture is
// RGBA8888 in sRGB if sRGB contains the colours, otherwise wide (base/WideGamut.h). `profile`
// describes the picture's own space: CMYK for inks, grey or RGB for an image. An image's own colour
// space is ignored. All overloads throw Error, naming `where`, if the profile is damaged or does
// not match the pixels. If colours lie visibly outside wide colour, a note in the texture states
// their share (base/ColourNote.h).
QImage textureOf(const LabPicture& picture, const QString& where);
QImage textureOf(const InkPicture& picture, const QByteArray& profile, const QString& where);
QImage textureOf(const QImage& picture, const QByteArray& profile, const QString& where);
// Converts to RGBA8888 in sRGB; colours outside sRGB become the nearest ones in it.
QImage srgbOf(const QImage& picture, const QByteArray& profile, const QString& where);

} // namespace dipwright

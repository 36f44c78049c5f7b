// Parses details of picture files that decoders do not report. Private to this folder.
#pragma once

#include <QByteArray>

#include <optional>

namespace dipwright {

struct JpegMarker {
    int kind = 0;       // the byte after 0xff
    QByteArray segment; // its data, without the length
    qsizetype end = 0;  // position from which to search for the next marker
};

// Returns the first marker of a JPEG file (ITU-T T.81, annex B) at or after `at`. Skips fill bytes
// and the bits of a scan, in which only restart markers can occur. Returns nothing if the file ends
// before the marker does.
std::optional<JpegMarker> nextJpegMarker(const QByteArray& file, qsizetype at);
constexpr int jpegScan = 0xda; // kind of the marker before the bits of a scan

// Whether a JPEG file, or an uncompressed BMP file, ends before its picture does. Decoders silently
// fill the rest with grey or black. Data after the picture does not matter.
bool isCutOff(const QByteArray& file);

// Returns the data of the first chunk of a kind in a PNG file (ISO/IEC 15948), either before the
// pixels or anywhere. Returns nothing if there is none.
enum class PngPlace { BeforePixels, Anywhere };
std::optional<QByteArray> pngChunk(const QByteArray& file, QByteArrayView kind,
                                   PngPlace place = PngPlace::BeforePixels);

// Returns the data of the first chunk of a kind in a WebP file, whose header announces it by
// `flag` (WebPFeatureFlags). Returns nothing if the header does not announce it or the file is
// damaged, and no bytes if the announced chunk is missing.
std::optional<QByteArray> webpChunk(const QByteArray& file, const char* kind, quint32 flag);

// Returns the TIFF structure that holds the EXIF tags (CIPA DC-008) of a file: a TIFF file itself,
// or a part of a JPEG, PNG or WebP file. Empty if there is none.
QByteArray exifOf(const QByteArray& file);

// Whether a PNG file names a colour space other than sRGB by a cICP chunk (PNG, third edition,
// 11.3.2.6). Decoders here do not read this chunk.
bool namesUnreadSpace(const QByteArray& file);

} // namespace dipwright

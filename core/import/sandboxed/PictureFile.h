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

// Returns the data of the first chunk of a kind that lies before the pixels of a PNG file (ISO/IEC
// 15948). Returns nothing if there is none.
std::optional<QByteArray> pngChunk(const QByteArray& file, QByteArrayView kind);

// Whether a PNG file names a colour space other than sRGB by a cICP chunk (PNG, third edition,
// 11.3.2.6). Decoders here do not read this chunk.
bool namesUnreadSpace(const QByteArray& file);

} // namespace dipwright

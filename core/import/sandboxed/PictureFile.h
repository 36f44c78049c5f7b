// How the files of pictures are laid out, as far as decoders do not tell. Private to this folder.
#pragma once

#include <QByteArray>

#include <optional>

namespace dipwright {

struct JpegMarker {
    int kind = 0;       // the byte after 0xff
    QByteArray segment; // what belongs to it, without its length
    qsizetype end = 0;  // where the next may begin
};

// The first marker of a JPEG file (ITU-T T.81, annex B) at a place or after it, whatever stands in
// between: fill bytes, and the bits of a scan, in which only restarts can occur. None where the
// file ends before the marker does.
std::optional<JpegMarker> nextJpegMarker(const QByteArray& file, qsizetype at);
constexpr int jpegScan = 0xda; // the kind before the first of the bits

// Whether a JPEG file, or a BMP file that is not packed, ends before its picture does, the rest of
// which decoders make grey or black without a word. What follows a picture does not matter.
bool isCutOff(const QByteArray& file);

} // namespace dipwright

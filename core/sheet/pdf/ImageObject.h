// Makes an image object of a PDF from compressed pixels. Private to this folder.
#pragma once

#include "base/PackedPixels.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// Returns the image, stored without loss. The colour space `space` has as many channels as the
// pixels.
QPDFObjectHandle imageObject(QPDF& pdf, const PackedPixels& pixels, const QPDFObjectHandle& space);

} // namespace dipwright

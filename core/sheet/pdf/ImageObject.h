// Packed pixels as an image of a PDF. Private to this folder.
#pragma once

#include "base/PackedPixels.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// `space`: the colour space, of as many channels as the pixels have. Stored without loss.
QPDFObjectHandle imageObject(QPDF& pdf, const PackedPixels& pixels, const QPDFObjectHandle& space);

} // namespace dipwright

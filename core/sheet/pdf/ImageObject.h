// Makes an image object of a PDF from compressed pixels. Private to this folder.
#pragma once

#include "base/PackedPixels.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// `space`: the colour space, with as many channels as the pixels. The image is stored without loss.
QPDFObjectHandle imageObject(QPDF& pdf, const PackedPixels& pixels, const QPDFObjectHandle& space);

} // namespace dipwright

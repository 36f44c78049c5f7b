// Makes an image object of a PDF from compressed pixels. Private to this folder.
#pragma once

#include "base/PackedPixels.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// Returns the image, stored without loss. The colour space `space` has as many channels as the
// pixels. The image refers to `pixels`, which must outlive `pdf`.
QPDFObjectHandle imageObject(QPDF& pdf, const PackedPixels& pixels, const QPDFObjectHandle& space);

} // namespace dipwright

// What a camera has written into its photo, from bytes that nobody has looked at yet.
#pragma once

#include "import/trusted/ReaderMessages.h"

namespace dipwright {

// Of JPEG and TIFF files, by their EXIF tags (CIPA DC-008, EXIF 2.3). What is missing, broken or
// out of range is left out. Throws nothing.
PhotoFacts photoFacts(const QByteArray& file);

} // namespace dipwright

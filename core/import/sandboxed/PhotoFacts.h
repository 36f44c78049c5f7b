// Reads the data that a camera writes into a photo, from untrusted bytes.
#pragma once

#include "import/trusted/ReaderMessages.h"

namespace dipwright {

// Reads the EXIF tags (CIPA DC-008, EXIF 2.3) of a JPEG, TIFF, PNG or WebP file. Leaves out tags
// that are missing, broken or out of range. Does not throw.
PhotoFacts photoFacts(const QByteArray& file);

// Returns the EXIF tag for how such a file is to be shown, 1 … 8; 1, as stored, if it has none.
int exifOrientation(const QByteArray& file);

} // namespace dipwright

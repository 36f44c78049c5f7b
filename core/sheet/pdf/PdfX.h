// PDF/X-4 (ISO 15930-7:2010): documents that a print shop's queue takes unseen. They say what inks
// they are for, where the page is trimmed, that nobody has trapped them yet and, in XMP, what they
// are. Private to this folder.
#pragma once

#include "sheet/pdf/PdfDocument.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// Whether PDF/X can have it as output intent: the ICC profile of an output device, by its header.
bool isOutputDevice(const QByteArray& profile);

// Says that a document is PDF/X-4: XMP metadata of which nothing comes from the clock, and the
// document's information in agreement with it. The caller sees to the rest: fonts embedded, a trim
// box on each page, an output intent, colours of its space only.
void declarePdfX(QPDF& pdf, const PdfSettings& settings);

} // namespace dipwright

// Declares a document as PDF/X-4 (ISO 15930-7:2010), which a print shop accepts without inspection.
// It says which inks it is for, where the page is trimmed, that it is not trapped yet and, in XMP,
// what it is. Private to this folder.
#pragma once

#include "sheet/pdf/PdfDocument.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// Tells whether PDF/X accepts the ICC profile as output intent: its header must name an output
// device.
bool isOutputDevice(const QByteArray& profile);

// Adds XMP metadata and matching document information, without anything from the clock. The caller
// provides the rest: embedded fonts, a trim box on each page, an output intent, and colours of its
// space only.
void declarePdfX(QPDF& pdf, const PdfSettings& settings);

} // namespace dipwright

// Declares a document as PDF/X-4 (ISO 15930-7:2010), or for older raster image processors as
// PDF/X-1a:2003 (ISO 15930-4:2003), which a print shop accepts without inspection.
// Such a document states its inks and trim boxes, that it is not trapped yet, and, in XMP, its
// title and type. Private to this folder.
#pragma once

#include "sheet/pdf/PdfDocument.h"

#include <qpdf/QPDF.hh>

namespace dipwright {

// Tells whether PDF/X accepts the ICC profile as output intent. It does if the profile's header
// names an output device.
bool isOutputDevice(const QByteArray& profile);

// Tells whether the pages are in CMYK and for a raster image processor that knows only PDF 1.4.
bool isForOlderRip(const PdfSettings& settings);

// Adds XMP metadata and matching document information, without the present time. Before the call,
// the document must have embedded fonts, a trim box on each page and an output intent. All its
// colours must be in the output intent's colour space.
void declarePdfX(QPDF& pdf, const PdfSettings& settings);

} // namespace dipwright

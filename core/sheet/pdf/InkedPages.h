// Adds PDF pages in CMYK and spot inks, which Qt cannot write. Lettering is drawn as outlines.
#pragma once

#include "sheet/pdf/PdfDocument.h"

#include <QPainterPath>

class QPDF;

namespace dipwright {

// Black on every plate, spot plates included, for marks that show whether the plates register.
inline const QColor registrationBlack = QColor::fromCmyk(255, 255, 255, 255);

// Adds the pages, drawn by their painters, to a document. Greys are in black ink only, CMYK colours
// are kept, and registrationBlack becomes the separation All. Any image that a page draws is
// replaced by `plates`.
void addInkedPages(QPDF& pdf, const std::vector<PdfPage>& pages, const Plates& plates);

// Tells whether the painter's page is in inks.
bool isInkedPage(const QPainter& painter);
// Draws the cut contour in its own spot ink, printed over the other inks. The page must take spots.
// If there is a bleed, the contour's bounding box becomes the page's trim box, and that box
// enlarged by `bleed` mm becomes its bleed box.
void strokeCut(QPainter& painter, const QPainterPath& path, double width, const SpotInk& spot,
               double bleed);

} // namespace dipwright

// Adds PDF pages in CMYK and spot inks, which Qt cannot write. Lettering is drawn as outlines.
#pragma once

#include "sheet/pdf/PdfDocument.h"

#include <QPainterPath>

class QPDF;

namespace dipwright {

// Full ink on every plate, including spot plates, for marks that show whether the plates register.
inline const QColor registrationBlack = QColor::fromCmyk(255, 255, 255, 255);

// Adds the pages, drawn by their painters, to a document. Greys become black ink only, CMYK colours
// stay as they are, and registrationBlack becomes the separation All. `plates` replaces any image
// that a page draws.
// They print over each other as `target` needs it, and must outlive `pdf`.
void addInkedPages(QPDF& pdf, const std::vector<PdfPage>& pages, const PackedPlates& plates,
                   PdfTarget target);

// Tells whether the painter draws on a page of addInkedPages().
bool isInkedPage(const QPainter& painter);
// Draws the cut contour in its own spot ink, printed over the other inks. The page must be an inked
// page. If `bleed` is not 0, the contour's bounding box becomes the page's trim box, and the trim
// box enlarged by `bleed` mm becomes its bleed box.
void strokeCut(QPainter& painter, const QPainterPath& path, double width, const SpotInk& spot,
               double bleed);

} // namespace dipwright

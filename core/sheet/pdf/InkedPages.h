// Pages of a PDF in inks: what Qt's PDF files have no words for. Lettering is drawn as outlines.
#pragma once

#include "sheet/pdf/PdfDocument.h"

#include <QPainterPath>

class QPDF;

namespace dipwright {

// Black that is on every plate, spots too: marks by which plates are laid over each other.
inline const QColor registrationBlack = QColor::fromCmyk(255, 255, 255, 255);

// Adds the pages, drawn by their painters, to a document: greys in black ink only, CMYK colours as
// they are, registrationBlack in the separation All. Whatever image a page draws stands for
// `plates`.
void addInkedPages(QPDF& pdf, const std::vector<PdfPage>& pages, const Plates& plates);

// Whether the painter's page is in inks.
bool takesSpots(const QPainter& painter);
// Draws the line along which is cut in a spot ink of its own, over the other inks and not in place
// of them, on a page that takes spots. Where there is a bleed, what is in the line is the page's
// trim box, and what is so many mm round it its bleed box.
void strokeCut(QPainter& painter, const QPainterPath& path, double width, const SpotInk& spot,
               double bleed);

} // namespace dipwright

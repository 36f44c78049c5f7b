// Draws pages into a PDF with Qt. The drawing has true size, but the pages' boxes are rounded to
// whole points, the file contains a date, and viewers may scale it. pdfDocument() corrects all
// this.
#pragma once

#include "sheet/pdf/PdfDocument.h"

namespace dipwright {

// Converts mm to points (1/72 inch).
QSizeF inPoints(QSizeF millimetres);

// Draws each page from the upper left corner of its box; the box is rounded up. If `imagesLater` is
// true, the caller replaces the images. Needs a QGuiApplication.
QByteArray drawnPdf(const std::vector<PdfPage>& pages, const QString& title, bool imagesLater);
// Whether the painter draws a page for a call of drawnPdf() with `imagesLater`.
bool drawsImagesLater(const QPainter& painter);

} // namespace dipwright

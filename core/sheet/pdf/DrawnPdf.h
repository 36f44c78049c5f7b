// Draws pages into a PDF with Qt. They have true size, but their boxes are rounded to whole points,
// the file has a date, and viewers may scale it. pdfDocument() makes the file exact.
#pragma once

#include "sheet/pdf/PdfDocument.h"

namespace dipwright {

// A point is 1/72 inch.
QSizeF inPoints(QSizeF millimetres);

// Draws each page from the upper left corner of its box, which is rounded up. `imagesLater`: the
// caller replaces the images. Needs a QGuiApplication.
QByteArray drawnPdf(const std::vector<PdfPage>& pages, const QString& title, bool imagesLater);
// Whether the painter draws on a page of drawnPdf() whose images are replaced.
bool drawsImagesLater(const QPainter& painter);

} // namespace dipwright

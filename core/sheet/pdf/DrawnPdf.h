// Pages as Qt draws them into a PDF: at true size, but in boxes of whole points, with a date, and
// as viewers may scale them. pdfDocument() makes them exact.
#pragma once

#include "sheet/pdf/PdfDocument.h"

namespace dipwright {

// A point is 1/72 inch.
QSizeF inPoints(QSizeF millimetres);

// Each page drawn from its box's upper left corner, the box rounded up. Needs a QGuiApplication.
// `imagesLater`: others will be put in place of the images (drawsImagesLater()).
QByteArray drawnPdf(const std::vector<PdfPage>& pages, const QString& title, bool imagesLater);
bool drawsImagesLater(const QPainter& painter);

} // namespace dipwright

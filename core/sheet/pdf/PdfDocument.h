// Writes PDF files of pages at true size.
//
// Qt draws RGB pages, and the engine in InkedPages.cpp draws CMYK pages. qpdf then makes the file
// exact and reproducible. Boxes are set to a fraction of a point, print dialogs do not scale, and
// there is an output intent. No date or identifier comes from the clock. If the output profile is a
// printer's, the file is PDF/X-4.
#pragma once

#include "base/PackedPixels.h"
#include "sheet/pdf/Plates.h"

#include <QByteArray>
#include <QPainter>
#include <QSizeF>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

namespace dipwright {

// A page's size in mm and the function that draws it. The painter's unit is the millimetre, its
// origin the page's upper left corner.
struct PdfPage {
    QSizeF size;
    std::function<void(QPainter&)> paint;
};

struct PdfSettings {
    QString title;
    QString date;             // the work's date, ISO 8601; may be empty
    QByteArray outputProfile; // an ICC profile; empty: sRGB
    QString outputName = QStringLiteral("sRGB IEC61966-2.1");
    // For CMYK pages, whose profile is then CMYK too: the film's picture, in place of any image
    // that the pages draw. Null: the pages are in RGB.
    std::shared_ptr<const Plates> inks = {};
    // The same for RGB pages. Null: images stay as drawn.
    std::shared_ptr<const PackedPixels> picture = {};
};

// Whether the painter's page puts the film's picture in place of every image. Drawing an image of
// one pixel is then enough.
bool replacesImages(const QPainter& painter);

// Writes the pages as one file, in the order given; at least one. The same pages give the same
// bytes. Needs a QGuiApplication.
QByteArray pdfDocument(const std::vector<PdfPage>& pages, const PdfSettings& settings);

// Returns a PDF with its pages repeated, one copy after the other. Some print systems lose the
// number of copies, but none loses pages. The file hardly grows. Throws Error if `pdf` is not a
// PDF.
QByteArray repeatedPdf(const QByteArray& pdf, int copies);

} // namespace dipwright

// PDF files of pages at true size.
//
// Qt draws the pages, or, in CMYK, our own engine for its painters; qpdf then makes a file of them
// that is exact and always the same: boxes to a fraction of a point, no scaling in print dialogs,
// an output intent, and no date or identifier that comes from the clock. Where the output profile
// is that of a printer, the file is PDF/X-4.
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

// Its size in mm, and what draws it: a painter in mm, origin the page's upper left corner.
struct PdfPage {
    QSizeF size;
    std::function<void(QPainter&)> paint;
};

struct PdfSettings {
    QString title;
    QString date;             // of the work, ISO 8601; may be empty
    QByteArray outputProfile; // an ICC profile; empty: sRGB
    QString outputName = QStringLiteral("sRGB IEC61966-2.1");
    // Of pages in CMYK, as the profile then is: the film's picture, in place of whatever image the
    // pages draw. Null: in RGB.
    std::shared_ptr<const Plates> inks = {};
    // The same of pages in RGB. Null: images are as they are drawn.
    std::shared_ptr<const PackedPixels> picture = {};
};

// Whether the painter's page puts the film's picture in place of every image: one pixel will do.
bool replacesImages(const QPainter& painter);

// The pages as one file, in the order given, at least one. Same bytes for the same pages. Needs a
// QGuiApplication.
QByteArray pdfDocument(const std::vector<PdfPage>& pages, const PdfSettings& settings);

// A PDF with its pages repeated, one copy after the other. Print systems lose a wish for copies on
// some of their ways; pages they do not. Takes hardly more room. Throws Error when it is no PDF.
QByteArray repeatedPdf(const QByteArray& pdf, int copies);

} // namespace dipwright

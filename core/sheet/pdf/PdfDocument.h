// Writes PDF files of pages at true size.
//
// Qt draws RGB pages, and the engine in InkedPages.cpp draws CMYK pages. qpdf then makes the file
// exact and reproducible. It gives each page its size in fractions of a point, because Qt rounds
// the size to whole points. It tells print dialogs not to scale, adds an output intent, and takes
// no date or identifier from the clock. If the output profile belongs to a printer, the file is
// PDF/X-4, or PDF/X-1a for older raster image processors.
#pragma once

#include "base/PackedPixels.h"
#include "settings/PdfTarget.h"
#include "sheet/pdf/Plates.h"

#include <QByteArray>
#include <QIODevice>
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
    QString date; // date of the project, ISO 8601; may be empty
    // An ICC profile. Empty: the pages are in sRGB, and their colours refer to its profile. With a
    // printer's RGB profile they are device colours, which the printer prints as they are.
    QByteArray outputProfile;
    QString outputName = QStringLiteral("sRGB IEC61966-2.1");
    // The film's picture, which replaces any image that the pages draw. The pages and the output
    // profile are then in CMYK. Null: the pages are in RGB.
    std::shared_ptr<const PackedPlates> inks = {};
    PdfTarget pdfTarget = PdfTarget::Ghostscript; // for `inks`
    // The film's picture for RGB pages, which replaces any image that they draw. Null: images stay
    // as drawn.
    std::shared_ptr<const PackedPixels> picture = {};
};

// Tells whether the film's picture replaces every image on the painter's page. If so, the painter
// may draw an image of one pixel.
bool replacesImages(const QPainter& painter);

// Returns one PDF file with the pages in the given order. Needs at least one page. The same pages
// give the same bytes. Needs a QGuiApplication.
QByteArray pdfDocument(const std::vector<PdfPage>& pages, const PdfSettings& settings);
// Writes the same file to a device without keeping it in memory. Throws Error, which names `where`,
// if `device` cannot be written. %1 in `message` becomes the device's reason.
void writePdf(const std::vector<PdfPage>& pages, const PdfSettings& settings, QIODevice& device,
              const QString& message, const QString& where);

// Returns a PDF in which the pages of `pdf` are repeated, one copy after the other. Use it for
// print systems that ignore the number of copies. The file hardly grows. Throws Error if `pdf` is
// not a PDF.
QByteArray repeatedPdf(const QByteArray& pdf, int copies);

} // namespace dipwright

// PDF files of pages at true size. Private to this folder.
//
// Qt draws the pages; qpdf then makes a file of them that is exact and always the same: boxes to a
// fraction of a point, no scaling in print dialogs, an output intent, and no date or identifier
// that comes from the clock.
#pragma once

#include "sheet/Sheet.h"

#include <QByteArray>
#include <functional>
#include <vector>

namespace dipwright {

// Its size in mm, and what draws it: a painter in mm, origin the page's upper left corner.
struct PdfPage {
    QSizeF size;
    std::function<void(QPainter&)> paint;
};

struct PdfSettings {
    QString title;
    QByteArray outputProfile; // an RGB ICC profile; empty: sRGB
    QString outputName = QStringLiteral("sRGB IEC61966-2.1");
};

// A sheet in the printer's colours, and how its document is to be written. Throws Error for a
// colour that PDF pages cannot be written in.
struct PreparedSheet {
    Sheet sheet;
    PdfSettings settings;
};
PreparedSheet preparedSheet(const Sheet& sheet, const PrintCorrection& correction);

QByteArray pdfDocument(const std::vector<PdfPage>& pages, const PdfSettings& settings);

} // namespace dipwright

#include "sheet/prepress/SheetFiles.h"

#include "base/Bytes.h"
#include "base/Png.h"
#include "sheet/page/SheetRows.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

// Returns the compressed film image on white for RGB files: in the RGB of `colour`, or in sRGB if
// it is null.
PackedPixels packedFilm(const Sheet& sheet, const PrinterColour* colour) {
    return packedPixels({filmPixels(sheet), 3, 8, [&](int first, int end) {
                             const Sheet rows = sheetRows(sheet, first, end);
                             return flattened(colour ? colour->rgb(rows.image) : rows.image);
                         }});
}

} // namespace

PreparedSheet preparedSheet(const Sheet& sheet, const PrintCorrection& correction) {
    PreparedSheet prepared{sheet, {}};
    QStringList names{sheet.job.project.simplified(), sheet.job.immersion.simplified()};
    names.removeAll(QString());
    prepared.settings.title = names.join(QStringLiteral(" – ")); // each dip has its own title
    prepared.settings.date = sheet.job.date.simplified();
    if (correction.colour) {
        prepared.settings.outputProfile = correction.colour->iccProfile();
        prepared.settings.outputName = correction.colour->description();
        if (correction.colour->isCmyk()) {
            prepared.settings.inks =
                std::make_shared<const PackedPlates>(RowSeparation(sheet, correction).packed());
            prepared.settings.pdfTarget = correction.pdfTarget;
            return prepared;
        }
    }
    prepared.settings.picture =
        std::make_shared<const PackedPixels>(packedFilm(sheet, correction.colour));
    return prepared;
}

QByteArray sheetPng(const PreparedSheet& prepared) {
    const int dotsPerMetre =
        int(std::lround(pixelsPerMillimetre(prepared.sheet.settings.resolution) * 1000));
    return pngBytes(*prepared.settings.picture,
                    {dotsPerMetre, dotsPerMetre, QColorSpace(QColorSpace::SRgb)});
}

namespace {

PdfPage pdfPage(const Sheet& sheet, const PrintCorrection& correction) {
    const QSizeF page = pageSize(sheet);
    return {correction.acrossPaper ? page.transposed() : page,
            [&sheet, &correction](QPainter& painter) {
                paintCorrectedSheet(painter, sheet, correction);
            }};
}

} // namespace

QByteArray sheetPdf(const PreparedSheet& prepared, const PrintCorrection& correction) {
    return pdfDocument({pdfPage(prepared.sheet, correction)}, prepared.settings);
}

void writeSheetPng(const Sheet& sheet, QIODevice& device) {
    writeTo(device, sheetPng(preparedSheet(sheet, {})),
            Text::tr("The sheet's PNG cannot be written: %1"), QStringLiteral("sheet.png"));
}

void writeSheetPdf(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction) {
    const PreparedSheet prepared = preparedSheet(sheet, correction);
    writePdf({pdfPage(prepared.sheet, correction)}, prepared.settings, device,
             Text::tr("The sheet's PDF cannot be written: %1"), QStringLiteral("sheet.pdf"));
}

} // namespace dipwright

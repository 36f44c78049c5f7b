#include "printing/PrintFile.h"

#include "disk/WholeFile.h"
#include "sheet/SheetFiles.h"

namespace dipwright {

std::unique_ptr<PrinterColour> printerColour(const std::optional<PrinterProfile>& profile) {
    return !profile || profile->iccProfile.isEmpty()
               ? nullptr
               : std::make_unique<PrinterColour>(profile->iccProfile, profile->intent,
                                                 profile->blackPoint, profile->name);
}

PrintCorrection printCorrection(const std::optional<PrinterProfile>& profile,
                                const PrinterColour* colour) {
    PrintCorrection correction;
    correction.colour = colour;
    if (profile) {
        correction.scaleX = profile->scaleX;
        correction.scaleY = profile->scaleY;
    }
    return correction;
}

bool isTiff(const QString& path) {
    return path.endsWith(QLatin1String(".tif"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".tiff"), Qt::CaseInsensitive);
}

void writePrintFile(const Sheet& sheet, const std::optional<PrinterProfile>& profile,
                    const QString& path) {
    const std::unique_ptr<PrinterColour> colour = printerColour(profile);
    const PrintCorrection correction = printCorrection(profile, colour.get());
    writeWhole(path, [&](QIODevice& device) {
        if (isTiff(path)) {
            writeSheetTiff(sheet, device, correction);
        } else {
            writeSheetPdf(sheet, device, correction);
        }
    });
}

PrintProof printProof(const QImage& page, const PrinterColour& colour, bool marked) {
    const GamutWarning warning = colour.gamutWarning(page);
    PrintProof proof{colour.softProof(page).convertToFormat(QImage::Format_RGB32), 0};
    qint64 painted = 0;
    qint64 outside = 0;
    for (int y = 0; y < page.height(); ++y) {
        const uchar* mask = warning.mask.constScanLine(y);
        auto* row = reinterpret_cast<QRgb*>(proof.page.scanLine(y));
        for (int x = 0; x < page.width(); ++x) {
            const bool isPaper = (page.pixel(x, y) & 0xffffff) == 0xffffff;
            painted += !isPaper;
            outside += !isPaper && mask[x] != 0;
            if (marked && !isPaper && mask[x] != 0) {
                row[x] = qRgb(255, 0, 255);
            }
        }
    }
    proof.outOfGamut = painted > 0 ? double(outside) / double(painted) : 0;
    return proof;
}

} // namespace dipwright

#include "printing/PrintFile.h"

#include "base/Error.h"
#include "base/Sha256.h"
#include "disk/AtomicFile.h"
#include "printing/PrintReach.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/page/SheetLayout.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Printing)
};

constexpr double leastShortfall = 1; // mm²; smaller areas are not reported

// Returns text that describes the profile's effect on a sheet's plates, or an empty text if it has
// none. Profiles that make the same plates have the same text.
QByteArray platesText(const PrinterProfile& profile) {
    QByteArrayList parts;
    if (profile.scaleX != 1 || profile.scaleY != 1) {
        parts << "scale " + QByteArray::number(profile.scaleX, 'g', 17) + ' ' +
                     QByteArray::number(profile.scaleY, 'g', 17);
    }
    if (!profile.iccProfile.isEmpty()) {
        parts << "icc " + sha256Hex(profile.iccProfile).toLatin1()
              << "intent " + QByteArray::number(int(profile.intent))
              << "black " + QByteArray::number(int(profile.blackPoint));
        if (profile.totalInk) {
            parts << "ink " + QByteArray::number(*profile.totalInk, 'g', 17);
        }
        if (profile.keptInks != KeptInks::None) {
            parts << "kept " + QByteArray::number(int(profile.keptInks));
        }
        if (!profile.deviceLink.isEmpty()) {
            parts << "link " + sha256Hex(profile.deviceLink).toLatin1();
        }
    }
    return parts.join('\n');
}

} // namespace

std::unique_ptr<PrinterColour> printerColour(const std::optional<PrinterProfile>& profile) {
    return !profile || profile->iccProfile.isEmpty()
               ? nullptr
               : std::make_unique<PrinterColour>(*profile, profile->name);
}

TileSettings tileSettings(QSizeF paper, const QMarginsF& lost) {
    TileSettings settings;
    settings.paper = paper;
    settings.margins = larger(lost, settings.margins);
    return settings;
}

Sheet numberedFor(const std::optional<PrinterProfile>& profile, const Sheet& sheet) {
    constexpr int digits = 6;
    const QByteArray plates = profile ? platesText(*profile) : QByteArray();
    Sheet numbered = sheet;
    if (plates.isEmpty()) {
        return numbered;
    }
    const QString suffix = QLatin1Char('-') + sha256Hex(plates).left(digits);
    numbered.job.hash += suffix;
    for (SheetPiece& piece : numbered.pieces) {
        const QString number = piece.job.hash + suffix;
        if (piece.whole && !piece.job.hash.isEmpty()) {
            SheetLayout whole = *piece.whole;
            whole.jobLineText.replaceInStrings(piece.job.hash, number);
            piece.whole = std::make_shared<const SheetLayout>(whole);
        }
        piece.job.hash = number;
    }
    return numbered;
}

bool isTiff(const QString& path) {
    return path.endsWith(QLatin1String(".tif"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".tiff"), Qt::CaseInsensitive);
}

QStringList leftOut(const Sheet& sheet, const PrintCorrection& correction, bool tiff) {
    const bool inks = correction.colour && correction.colour->isCmyk();
    QStringList sentences = lostPlates(sheet, inks);
    if (sheet.settings.cutLine != CutLine::None && (tiff || !inks)) {
        sentences << Text::tr("The cut contour is left out: it needs a PDF and a printer profile "
                              "with an ICC profile in CMYK");
    }
    if (sheet.passes > 1) {
        sentences << Text::tr("Each sheet must be printed %1 times onto the same film, without "
                              "moving it: the project prints its ink in %1 passes")
                         .arg(sheet.passes);
    }
    const double area = inkShortfall(sheet, correction);
    if (area >= leastShortfall) {
        sentences
            << Text::tr(
                   "%1 mm² of the part will be visibly too pale: the stretched film needs more ink "
                   "there than full ink, the ink limit and the total area coverage allow")
                   .arg(std::round(area));
    }
    return sentences;
}

namespace {

QStringList writeSheetFile(const Sheet& sheet, const PrintFileRequest& request,
                           const QString& path) {
    const std::unique_ptr<PrinterColour> colour = printerColour(request.profile);
    const PrintCorrection correction = printCorrection(request.profile, colour.get());
    const QMarginsF margins = unreachable({}, request.profile);
    QStringList warnings = leftOut(sheet, correction, isTiff(path));
    if (request.tilePaper) {
        if (isTiff(path)) {
            throw Error(Text::tr("A sheet in tiles can only be written as PDF, one page for each "
                                 "tile; end the file name in .pdf"),
                        path);
        }
        const TileSettings tiles =
            tileSettings(*request.tilePaper, clippedEdges(*request.tilePaper, margins, correction));
        writeAtomically(
            path, [&](QIODevice& device) { writeTiledPdf(sheet, tiles, device, correction); });
        return warnings;
    }
    const Sheet inside =
        withinReach(sheet, margins, correction, request.acceptClipping, path, warnings);
    writeAtomically(path, [&](QIODevice& device) {
        if (isTiff(path)) {
            writeSheetTiff(inside, device, correction);
        } else {
            writeSheetPdf(inside, device, correction);
        }
    });
    return warnings;
}

} // namespace

QStringList writePrintFile(const Sheet& original, const PrintFileRequest& request,
                           const QString& path, const PrintHistory& history) {
    const Sheet sheet = numberedFor(request.profile, original);
    QStringList warnings = writeSheetFile(sheet, request, path);
    PrintRecord record = recordOf(sheet, request.source, request.profile,
                                  request.tilePaper.value_or(pageSize(sheet)));
    record.file = QFileInfo(path).absoluteFilePath();
    record.fate = PrintOutcome::WrittenToFile;
    const QString failure = history.keep(record);
    if (!failure.isEmpty()) {
        warnings << historyErrorText(failure);
    }
    return warnings;
}

const QImage& requestedColours(const Sheet& sheet, const PrinterColour& colour) {
    return sheet.wanted && colour.isCmyk() ? sheet.wanted->image : sheet.image;
}

namespace {

// Tells for each pixel of a row whether its amounts of ink are printed without a separation.
std::vector<bool> keptAmounts(const InkPlanes& inks, int y, const PrinterColour& colour) {
    const auto width = std::size_t(inks.colours.width());
    const uchar* const colours = inks.colours.constScanLine(y);
    const uchar* const black = inks.black.constScanLine(y);
    std::vector<std::uint8_t> amounts(4 * width), separated(4 * width);
    for (std::size_t at = 0; at < amounts.size(); ++at) {
        amounts[at] = at % 4 < 3 ? colours[at] : black[at - 3];
        separated[at] = std::uint8_t(255 - amounts[at]); // differs from every amount that is kept
    }
    colour.convertInks(amounts, inks.space, separated);
    std::vector<bool> kept(width);
    for (std::size_t x = 0; x < width; ++x) {
        kept[x] = black[4 * x + 1] != 0 &&
                  !std::equal(&amounts[4 * x], &amounts[4 * x] + 4, &separated[4 * x]);
    }
    return kept;
}

} // namespace

GamutWarning sheetGamut(const Sheet& sheet, const PrinterColour& colour, const QImage& colours) {
    GamutWarning warning = colour.gamutWarning(colours);
    if (!colour.isCmyk() || !sheet.wanted || sheet.wanted->inks.isNull()) {
        return warning;
    }
    qint64 outside = 0, separated = 0;
    for (int y = 0; y < warning.mask.height(); ++y) {
        const std::vector<bool> kept = keptAmounts(sheet.wanted->inks, y, colour);
        uchar* const mask = warning.mask.scanLine(y);
        for (std::size_t x = 0; x < kept.size(); ++x) {
            outside += mask[x] != 0;
            mask[x] = kept[x] ? 0 : mask[x];
            separated += mask[x] != 0;
        }
    }
    warning.share *= outside > 0 ? double(separated) / double(outside) : 1;
    return warning;
}

PrintProof printProof(const Sheet& sheet, const PrintCorrection& correction, bool marked) {
    const PrinterColour& colour = *correction.colour;
    const QImage page = onWhitePaper(requestedColours(sheet, colour));
    const GamutWarning warning = sheetGamut(sheet, colour, page);
    const QImage shown = sheet.wanted && colour.isCmyk()
                             ? colour.screen(separate(sheet, correction).cmyk, page.size())
                             : colour.softProof(page);
    PrintProof proof{shown.convertToFormat(QImage::Format_RGB32), 0};
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

// Writes a sheet to a file in a printer's scale and colours, instead of printing it.
#pragma once

#include "printing/PrintHistory.h"
#include "settings/Profile.h"
#include "sheet/page/Sheet.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/TiledSheet.h"

#include <QStringList>
#include <memory>
#include <optional>

namespace dipwright {

// The profile's colours. Null without a profile, or if the profile has no colours. Throws Error.
std::unique_ptr<PrinterColour> printerColour(const std::optional<PrinterProfile>& profile);
// The profile's scales and ink limit (true size without a profile), with `colour`, which may be
// null.
PrintCorrection printCorrection(const std::optional<PrinterProfile>& profile,
                                const PrinterColour* colour);

// Tiles for this paper. They stay clear of its unprintable edges, and at least the usual distance
// from the paper's edges.
TileSettings tileSettings(QSizeF paper, const QMarginsF& lost);

// The sheet with the job numbers that it has when printed with the profile. If the profile changes
// scale, colours or inks, the job number gets a suffix: a dash and six hexadecimal digits of these
// changes. So different plates of one job have different numbers. On a film with several jobs, this
// applies to its pieces too.
Sheet numberedFor(const std::optional<PrinterProfile>& profile, const Sheet& sheet);

bool isTiff(const QString& path);

// Sentences on parts of the sheet that cannot be printed as designed. These are spot colours
// without a CMYK profile, and places where the ink cannot compensate the stretch.
QStringList leftOut(const Sheet& sheet, const PrintCorrection& correction, bool tiff);

struct PrintFileRequest {
    // Scales, margins and colours of the printer; none: true size and sRGB.
    std::optional<PrinterProfile> profile;
    // Splits the sheet into tiles for this paper, in mm; PDF only.
    std::optional<QSizeF> tilePaper;
    bool acceptClipping = false; // lose colour that the printer cannot reach
    PrintSource source;          // for the history
};

// Writes TIFF if the file name ends in .tif or .tiff, else PDF. Records the file in the print
// history. Returns warnings. Throws Error if the printer cannot reach colour near the sheet's edge,
// as for a printed sheet.
QStringList writePrintFile(const Sheet& original, const PrintFileRequest& request,
                           const QString& path, const PrintHistory& history);

// A sheet's film on white as the printer will show it, and the share of its paint that is out of
// gamut.
struct PrintProof {
    QImage page; // opaque, sRGB
    double outOfGamut = 0;
};
// `correction` must have a colour. With `marked`, out-of-gamut places are painted magenta.
PrintProof printProof(const Sheet& sheet, const PrintCorrection& correction, bool marked);
// The colours requested from the printer. If it compensates each ink separately, these are the
// wanted colours, else those of the film image.
const QImage& requestedColours(const Sheet& sheet, const PrinterColour& colour);

} // namespace dipwright

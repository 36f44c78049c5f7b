// Writes a sheet to a file in a printer's scale and colours instead of printing it.
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

// Returns the profile's colours, or null without a profile or if the profile has no colours. Throws
// Error.
std::unique_ptr<PrinterColour> printerColour(const std::optional<PrinterProfile>& profile);

// Returns the settings for tiles on this paper. `lost` is the width of each edge that the printer
// cannot print. The margins of the tiles are at least as wide as `lost` and as the default of
// TileSettings.
TileSettings tileSettings(QSizeF paper, const QMarginsF& lost);

// Returns the sheet with the job numbers that it has when it is printed with the profile. If the
// profile changes scale, colours or inks, each job number gets a suffix: a dash and six hexadecimal
// digits that depend on these changes. So different plates of one job have different numbers. If
// the film has several jobs, each of its pieces gets such a number.
Sheet numberedFor(const std::optional<PrinterProfile>& profile, const Sheet& sheet);

bool isTiff(const QString& path);

// Returns sentences on parts of the sheet that cannot be printed as designed: spot colours without
// a CMYK profile, and places where the ink cannot compensate for the stretch.
QStringList leftOut(const Sheet& sheet, const PrintCorrection& correction, bool tiff);

struct PrintFileRequest {
    // Scales, margins and colours of the printer. Without a profile: true size and sRGB.
    std::optional<PrinterProfile> profile;
    // Splits the sheet into tiles for this paper, in mm; PDF only.
    std::optional<QSizeF> tilePaper;
    // Whether the print may lose colour in places that the printer cannot reach.
    bool acceptClipping = false;
    PrintSource source; // stored in the history
};

// Writes TIFF if the file name ends in .tif or .tiff, else PDF. Records the file in the print
// history. Returns warnings. Like printing, throws Error if colour lies near the sheet's edge where
// the printer cannot print.
QStringList writePrintFile(const Sheet& original, const PrintFileRequest& request,
                           const QString& path, const PrintHistory& history);

// A sheet's film on white, in the colours that the printer will show, and the share of the painted
// area that is out of gamut.
struct PrintProof {
    QImage page; // opaque, sRGB
    double outOfGamut = 0;
};
// Returns the soft proof. `correction` must have a colour. With `marked`, out-of-gamut places are
// painted magenta.
PrintProof printProof(const Sheet& sheet, const PrintCorrection& correction, bool marked);
// Returns the colours that are requested from the printer: the wanted colours if `colour`
// compensates each ink separately, else the colours of the film image.
const QImage& requestedColours(const Sheet& sheet, const PrinterColour& colour);
// Returns which of `colours`, the sheet's requested colours, are out of gamut. Amounts of ink that
// are printed without a separation are not.
GamutWarning sheetGamut(const Sheet& sheet, const PrinterColour& colour, const QImage& colours);

} // namespace dipwright

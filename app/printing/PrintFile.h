// A sheet as a file in a printer's scale and colours, in place of sending it there.
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

// The profile's colours; null where it has none, or there is no profile. Throws Error.
std::unique_ptr<PrinterColour> printerColour(const std::optional<PrinterProfile>& profile);
// The profile's scales and limit of ink, true size without one, with these colours (may be null).
PrintCorrection printCorrection(const std::optional<PrinterProfile>& profile,
                                const PrinterColour* colour);

// Pieces on such paper, clear of its edges that are lost and never nearer to them than usual.
TileSettings tileSettings(QSizeF paper, const QMarginsF& lost);

// The sheet with the job numbers that it has when it is printed by the profile. Where that changes
// scale, colours or inks, a dash and six hexadecimal digits of what it changes follow the job's own
// number: different plates of one job have different numbers. Of a film with several jobs, those of
// its pieces too.
Sheet numberedFor(const std::optional<PrinterProfile>& profile, const Sheet& sheet);

bool isTiff(const QString& path);

// Sentences on what the sheet has and its print does not: spot inks, without a colour in CMYK, and
// ink where no more of it makes up for the stretch.
QStringList leftOut(const Sheet& sheet, const PrintCorrection& correction, bool tiff);

struct PrintFileRequest {
    // Scales, margins and colours of the printer; none: true scale and sRGB.
    std::optional<PrinterProfile> profile;
    // Cut into pieces of this paper, in mm; PDF only.
    std::optional<QSizeF> tilePaper;
    bool acceptClipping = false; // lose what lies where the printer does not reach
    PrintSource source;          // for the history
};

// PDF, or TIFF where the name ends so, kept in the history when it is written. Returns what is to
// be said about it. Throws Error, as for a sheet that is printed, where the printer does not reach
// colour near the sheet's edge.
QStringList writePrintFile(const Sheet& original, const PrintFileRequest& request,
                           const QString& path, const PrintHistory& history);

// A sheet's film on white as the printer will show it, and the share of its paint that the printer
// cannot make.
struct PrintProof {
    QImage page; // opaque, sRGB
    double outOfGamut = 0;
};
// `correction` with a colour. What is out of reach is painted over in magenta where `marked`.
PrintProof printProof(const Sheet& sheet, const PrintCorrection& correction, bool marked);
// The colours that the printer is asked for: where it compensates each ink by itself, those that
// are to show, else those of the film image.
const QImage& askedColours(const Sheet& sheet, const PrinterColour& colour);

} // namespace dipwright

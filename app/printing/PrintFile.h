// A sheet as a file in a printer's scale and colours, in place of sending it there.
#pragma once

#include "project/Profiles.h"
#include "sheet/Sheet.h"

#include <memory>
#include <optional>

namespace dipwright {

// The profile's colours; null where it has none, or there is no profile. Throws Error.
std::unique_ptr<PrinterColour> printerColour(const std::optional<PrinterProfile>& profile);
// The profile's scales, true size without one, with these colours (may be null).
PrintCorrection printCorrection(const std::optional<PrinterProfile>& profile,
                                const PrinterColour* colour);

bool isTiff(const QString& path);

// PDF, or TIFF where the name ends so; without a profile at true scale and in sRGB. Throws Error.
void writePrintFile(const Sheet& sheet, const std::optional<PrinterProfile>& profile,
                    const QString& path);

// A page as the printer will show it, and the share of its paint that the printer cannot make.
struct PrintProof {
    QImage page; // opaque, sRGB
    double outOfGamut = 0;
};
// `page`: opaque, sRGB. What is out of reach is painted over in magenta where `marked`.
PrintProof printProof(const QImage& page, const PrinterColour& colour, bool marked);

} // namespace dipwright

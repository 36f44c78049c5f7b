// Computes the corrections of a printer's profile, and what its margins and corrected scale leave
// of a sheet's paper.
#pragma once

#include "settings/Profile.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>
#include <optional>

namespace dipwright {

// Returns the profile's scales (true size without a profile) and ink limit, combined with `colour`,
// which may be null.
PrintCorrection printCorrection(const std::optional<PrinterProfile>& profile,
                                const PrinterColour* colour);

QMarginsF larger(const QMarginsF& a, const QMarginsF& b);
double widest(const QMarginsF& margins);

// Returns the unprintable margins of the printer's paper, in mm, from the printer's own report and
// from the profile's measurement.
QMarginsF unreachable(const QMarginsF& ofPrinter, const std::optional<PrinterProfile>& profile);

// Returns how much of the drawing is lost at each edge, in mm of the drawing before scaling. It is
// drawn centred on `paper` with the correction's scales. The loss is the margin, and more if the
// drawing becomes larger than the paper. That happens if the printer prints too small (a scale
// below 1), because the correction then enlarges the drawing.
QMarginsF clippedEdges(QSizeF paper, const QMarginsF& margins, const PrintCorrection& correction);

// Returns the distance at which marks, ruler and job line of a page are printed whole, whichever
// way the page lies on the paper: at least Sheet's default, beyond the margins.
Millimetres clearanceFor(QSizeF page, const QMarginsF& margins, const PrintCorrection& correction);

} // namespace dipwright

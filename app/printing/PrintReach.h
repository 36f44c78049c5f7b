// What of a sheet a printer reaches: its margins, and what a corrected scale moves past the paper.
#pragma once

#include "settings/Profile.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>
#include <QStringList>
#include <optional>

namespace dipwright {

QMarginsF larger(const QMarginsF& a, const QMarginsF& b);
double widest(const QMarginsF& margins);

// What the printer cannot reach of its paper, in mm: by its own word and by the profile's
// measurement.
QMarginsF unreachable(const QMarginsF& ofPrinter, const std::optional<PrinterProfile>& profile);

// What is lost of the drawing's edges, in its own mm, when it is drawn on `paper` with the
// correction's scales about the middle: the margins, and more where a scale below 1 makes the
// drawing larger than the paper.
QMarginsF lostEdges(QSizeF paper, const QMarginsF& margins, const PrintCorrection& correction);

// The sheet with marks, ruler and job line as far from the paper's edges as ever, and clear of its
// margins. Colour that is lost is an Error that says so, naming `where`, or with `accept` one more
// of the warnings.
Sheet withinReach(const Sheet& sheet, const QMarginsF& margins, const PrintCorrection& correction,
                  bool accept, const QString& where, QStringList& warnings);

} // namespace dipwright

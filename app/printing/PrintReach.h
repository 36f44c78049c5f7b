// Computes which part of a sheet a printer can reach. This depends on the printer's margins, and on
// a corrected scale that may enlarge the sheet beyond the paper.
#pragma once

#include "settings/Profile.h"
#include "sheet/packing/FilmPacking.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>
#include <QStringList>
#include <optional>

namespace dipwright {

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

// Returns the sheet with its marks, ruler and job line moved clear of the paper's margins, and at
// least the usual distance from the edges. If colour is lost, or if the cut contour leaves the
// paper, throws an Error that names `where`, or adds a warning if `accept` is set. Also warns of a
// cut contour in the margins.
Sheet withinReach(const Sheet& sheet, const QMarginsF& margins, const PrintCorrection& correction,
                  bool accept, const QString& where, QStringList& warnings);

// Returns the film with edges so wide that its pieces, ruler and job line lie where the printer
// prints at the profile's scale. `ofPrinter` are the printer's own margins. A roll gets the edges
// that its longest page needs.
PackingFilm withinReach(PackingFilm film, const QMarginsF& ofPrinter,
                        const std::optional<PrinterProfile>& profile);

} // namespace dipwright

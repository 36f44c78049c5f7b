// Computes which part of a sheet a printer can reach. This depends on the printer's margins, and on
// a corrected scale that may enlarge the sheet beyond the paper.
#pragma once

#include "settings/Profile.h"
#include "sheet/packing/FilmPacking.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>
#include <QStringList>
#include <optional>

namespace dipwright {

// Returns the sheet with its marks, ruler and job line moved clear of the paper's margins, and at
// least as far from the edges as before. Warns if marks on the film move away from the pins that
// traveller and cradle have for them. If colour is lost, or if the cut contour leaves the
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

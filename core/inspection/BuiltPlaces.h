// Finds where the film really lies on a dipped part, in places of the sheet (docs/inspection.md,
// "As built").
#pragma once

#include "dip/LaidFilm.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"
#include "settings/AsBuilt.h"

#include <QSize>
#include <QSizeF>
#include <memory>
#include <vector>

namespace dipwright {

// Returns, for each seen place, the offset on the sheet: the place of the simulated film that would
// appear there, less the place itself. If several photos show a place, the most frontal view
// counts. Places that lie past the paint's end, would move there, or are seen at too flat an angle
// are left out. `films` are those of the project's immersions, with sheets of the size `sheet`.
// `part` and `dip` count from 1.
std::vector<BuiltPlace> builtPlaces(const std::vector<PrintedPlace>& seen, const PartView& camera,
                                    QSize picture,
                                    const std::vector<std::shared_ptr<const LaidFilm>>& films,
                                    QSizeF sheet, int part);

// Moves places, given on the uncorrected sheet, to where a sheet corrected by `built` has them.
// Returns them unchanged if `built` corrects nothing.
std::vector<PrintedPlace> onPrintedSheet(std::vector<PrintedPlace> places, const AsBuilt& built);

// Returns the root mean square of the places' offsets, in mm on the sheet.
double residualOf(const std::vector<BuiltPlace>& places);

// Adds a part with these places to what the job keeps. The places already carry the part's future
// number. Fills in the residual of `part`. Throws Error, naming `where`, if there are no places, if
// the job already has the part's photos, or if its limits are exceeded.
AsBuilt withBuiltPart(AsBuilt built, const std::vector<BuiltPlace>& places, BuiltPart part,
                      const QString& where);

} // namespace dipwright

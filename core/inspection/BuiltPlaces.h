// Finds where each place of the sheet really lies on a dipped part (docs/inspection.md, "As
// built").
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/SurfaceQuery.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"
#include "settings/AsBuilt.h"

#include <QSize>
#include <QSizeF>
#include <memory>
#include <vector>

namespace dipwright {

// Returns the offset on the sheet of each seen place. The offset leads from the seen place to the
// place of the simulated film that would appear at the same pixel. If several photos show a place,
// the most frontal view counts. Leaves out places that lie outside the painted area, would move out
// of it, or are seen at too flat an angle. `films` holds the film of each of the project's
// immersions; `sheet` is the size of their sheets. `part` and `dip` count from 1.
std::vector<BuiltPlace> builtPlaces(const std::vector<PrintedPlace>& seen, const PartView& camera,
                                    QSize picture,
                                    const std::vector<std::shared_ptr<const LaidFilm>>& films,
                                    QSizeF sheet, int part);

// Throws Error, naming `where`, if the simulated films carry half of the places more than
// mostOffTarget away from their intended places on the model. The message names the likely mistake,
// such as a coordinate of the sheet with the wrong sign. `places` are on the uncorrected sheet.
// `films` and `sheet` are as for builtPlaces().
void requireOnTargets(const std::vector<PrintedPlace>& places,
                      const std::vector<std::shared_ptr<const LaidFilm>>& films, QSizeF sheet,
                      const QString& where);
// mm on the model. Places that are read from a sheet by hand, or simulated with other cells, are a
// millimetre or two off. Mirrored or swapped coordinates move places by tens of millimetres.
inline constexpr double mostOffTarget = 5;

// Throws Error, naming `where`, if more than the share mostOffBody of the places in these tables
// lie more than farOffBody from the surface of the job's model. Then they belong to another part,
// or their unit or frame is wrong. The targets of places and the places of pairs are compared.
void requireOnBody(const std::vector<PrintedPlace>& places, const SurfaceQuery& surface,
                   const QString& where);
void requireOnBody(const std::vector<PlacePair>& pairs, const SurfaceQuery& surface,
                   const QString& where);
// mm. Places that are measured by hand on a part, or read from its drawing, are less far off.
inline constexpr double farOffBody = 1;
inline constexpr double mostOffBody = 0.1;

// Converts places on the uncorrected sheet to the places where the corrected sheet shows the same
// image. `built` holds the parts that correct the sheet: partsDippedAlike() of the project. Returns
// the places unchanged if `built` corrects nothing.
std::vector<PrintedPlace> onPrintedSheet(std::vector<PrintedPlace> places, const AsBuilt& built);

// Returns the root mean square of the places' offsets, in mm on the sheet.
double residualOf(const std::vector<BuiltPlace>& places);

// Adds a part with these places to the parts of `built`. The places already carry the part's future
// number. Fills in the residual of `part`. `sheet` is the size of the sheets. Throws Error, naming
// `where`, if there are no places, if the job already has one of the part's photos, if its limits
// are exceeded, or if the errors of this part or of all parts that were dipped alike are impossible
// (requirePossibleErrors() in SheetCorrection.h).
AsBuilt withBuiltPart(AsBuilt built, const std::vector<BuiltPlace>& places, BuiltPart part,
                      QSizeF sheet, const QString& where);

} // namespace dipwright

// Where the film lies on a dipped part, told as places of the sheet (docs/inspection.md, "As
// built").
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

// Of each place that was seen, in the photo in which it was seen most from the front if in several:
// which place of the film as it was simulated would appear there, less the place itself. Left out
// are places that lie, or would lie, past the paint's end, or are seen too much from the side.
// `films`: of the project's immersions, with sheets of that size. `part` and `dip` count from 1.
std::vector<BuiltPlace> builtPlaces(const std::vector<PrintedPlace>& seen, const PartView& camera,
                                    QSize picture,
                                    const std::vector<std::shared_ptr<const LaidFilm>>& films,
                                    QSizeF sheet, int part);

// Places that are told where the film was made, moved to where a sheet that is corrected as `built`
// says has them; as they are where it corrects nothing.
std::vector<PrintedPlace> onPrintedSheet(std::vector<PrintedPlace> places, const AsBuilt& built);

// mm on the sheet, root mean square.
double residualOf(const std::vector<BuiltPlace>& places);

// What the job keeps with one part more, which has these places, of the number that part has then.
// `part`: its residual is filled in. Throws Error, naming `where`, where there are none, where the
// job has the part's photos already, and past what it keeps.
AsBuilt withBuiltPart(AsBuilt built, const std::vector<BuiltPlace>& places, BuiltPart part,
                      const QString& where);

} // namespace dipwright

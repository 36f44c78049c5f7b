// Finding which film is on the body at the end of a dip. Private to this folder: LaidFilm holds
// what is found.
#pragma once

#include "dip/FilmContact.h"
#include "dip/Pose.h"
#include "film/DippedFilm.h"
#include "settings/ProcessSettings.h"

namespace dipwright {

// Finds the surface point of every adhered film point: the nearest one along the film's normal, or
// the closest one where that ray goes astray; a point that floats under an air pocket has none, nor
// one whose place is in a pocket. A point that has none is filled from its neighbours
// where it has some on both sides, along the rows and along the columns. A film triangle is painted
// when all its corners lie on the body and it neither tears, nor spans a hollow, nor is folded
// across the body, nor lies on a face that turns up by more than `process.overhang`. The film's
// last points on the body are short of the limit of contact by a cell or so; isotropic film is
// continued up to it, see ContactLimit.h. `film` is in the body's pose frame. All cores,
// deterministic.
FilmContact filmThatPaints(const DippedFilm& film, const PosedBody& body,
                           const ProcessSettings& process);

} // namespace dipwright

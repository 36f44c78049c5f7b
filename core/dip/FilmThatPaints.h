// Finds which film is on the body at the end of a dip. Private to this folder; LaidFilm holds the
// result.
#pragma once

#include "dip/FilmContact.h"
#include "dip/Pose.h"
#include "film/DippedFilm.h"
#include "settings/ProcessSettings.h"

namespace dipwright {

// Finds the contact of a film with the body, in four steps:
// - Each adhered film point gets the nearest point of the surface along the film's normal. If that
//   ray misses, the film point gets the closest point. It gets none if it floats under an air
//   pocket, or if its place is in one.
// - A point without a place is interpolated from its neighbours along its row and its column. All
//   four must have a place.
// - A film triangle is painted if all its corners are on the body and it is not torn. It must not
//   span a hollow, fold across the body, or lie on a face that turns up by more than
//   `process.overhang`.
// - The painted film found so far ends about one cell before the limit of contact. Isotropic film
//   is extended to the limit; see ContactLimit.h.
// `film` is in the body's pose frame. Uses all cores; deterministic.
FilmContact findFilmContact(const DippedFilm& film, const PosedBody& body,
                            const ProcessSettings& process);

} // namespace dipwright

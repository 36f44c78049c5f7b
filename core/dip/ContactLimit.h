// Extends the film on the body to the line where contact ends. Private to this folder.
#pragma once

#include "dip/FilmContact.h"
#include "dip/Pose.h"
#include "film/DippedFilm.h"
#include "geometry/CornerNormals.h"
#include "settings/ProcessSettings.h"

namespace dipwright {

// Extends hanging film past its last points on the body, up to the limit of contact. At the limit,
// the body turns up by more than `process.overhang`, rises above the water or enters an air pocket.
// Fills `contact.limits`, and `contact.places` of the points past the limit; the rest of `contact`
// must be complete. The film continues along the body in its previous direction, for at most two
// cells. Film that is near its continued place without touching the body stays as it is. `normals`
// are the normals of the body.
void continueToLimit(const DippedFilm& film, const PosedBody& body, const CornerNormals& normals,
                     const ProcessSettings& process, FilmContact& contact);

} // namespace dipwright

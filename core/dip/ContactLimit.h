// Where the film on the body ends. Private to this folder.
#pragma once

#include "dip/FilmContact.h"
#include "dip/Pose.h"
#include "film/DippedFilm.h"
#include "geometry/CornerNormals.h"
#include "settings/ProcessSettings.h"

namespace dipwright {

// Continues film that hangs from the body past its last points there, up to where the body turns up
// by more than `process.overhang`, rises above the water or goes on in an air pocket: fills
// `contact.limits`, and `contact.places` of the points past it. The film goes on over the body as
// it lay before, for two cells at the most; film that is near its place there, but does not touch,
// is left as it is. `contact` is complete but for that; `normals` are the body's.
void continueToLimit(const DippedFilm& film, const PosedBody& body, const CornerNormals& normals,
                     const ProcessSettings& process, FilmContact& contact);

} // namespace dipwright

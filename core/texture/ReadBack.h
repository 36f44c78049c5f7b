// Measures how accurately the film image puts a body's texture back onto the body.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// Read-back error (docs/film-model.md, "Measures"), for about 20,000 points spread evenly over the
// painted surface. It is the distance on the body between the correct place of a texture point and
// the place where the sheet puts the point. The sheet was made for the film `planned` and is read
// on the film `laid`. In a job both films are the same, so the error does not include the
// simulation's error. `appearance` is the body's. Points within two film cells of the painted
// area's border are left out.
struct ReadBackError {
    double mean = 0, percentile95 = 0, maximum = 0; // mm
    std::size_t samples = 0;
};
ReadBackError readBackError(const LaidFilm& planned, const LaidFilm& laid,
                            const SurfaceAppearance& appearance);

} // namespace dipwright

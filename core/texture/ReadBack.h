// Measures how exactly a body's texture is read back through the film for which it was reversed.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// Read-back error (docs/film-model.md, "Measures"), for about 20,000 points spread evenly over the
// painted surface. It is the distance on the body between the right place of a texture point and
// the place where the sheet puts it.
// The sheet was made with the reverse map of the film `planned`. It is read where the film `laid`
// lies over the point. For a job the two films are the same, so that the error contains no error of
// the simulation. `appearance` is the body's. Points within two film cells of the painted area's
// border are left out.
struct ReadBackError {
    double mean = 0, percentile95 = 0, maximum = 0; // mm
    std::size_t samples = 0;
};
ReadBackError readBackError(const LaidFilm& planned, const LaidFilm& laid,
                            const SurfaceAppearance& appearance);

} // namespace dipwright

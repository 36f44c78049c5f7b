// How exactly a body's texture is read back through the film that it was reversed by.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// Read-back error (docs/film-model.md, "Measures"): for about 20,000 points spread evenly over
// the painted surface, the distance on the body between where a texture point should be and where
// the sheet puts it. The sheet is read where the film `laid` lies over the point, and shows there
// what the reverse map of the film `planned`, for which the sheet was made, has put there; of a job
// they are one, and the error is none of the simulation's. `appearance` is the body's. Points
// within two film cells of the painted area's border are left out.
struct ReadBackError {
    double mean = 0, percentile95 = 0, maximum = 0; // mm
    std::size_t samples = 0;
};
ReadBackError readBackError(const LaidFilm& planned, const LaidFilm& laid,
                            const SurfaceAppearance& appearance);

} // namespace dipwright

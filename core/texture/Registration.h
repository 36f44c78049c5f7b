// How well a printed sheet meets the body's texture.
#pragma once

#include "dip/FilmOnBody.h"

namespace dipwright {

// Registration error (film-physics §4): for about 20,000 points spread evenly over the painted
// surface, the distance on the body between where a texture point should be and where the sheet
// puts it. The sheet is read where the film lies over the point, and shows there what the reverse
// map has put there. Points within two film cells of the painted area's border are left out.
struct Registration {
    double mean = 0, percentile95 = 0, maximum = 0; // mm
    std::size_t samples = 0;
};
Registration registrationError(const DippedFilm& film, const FilmContact& contact,
                               const PosedBody& body, const SurfaceQuery& query,
                               const FilmOnBody& filmOnBody);

} // namespace dipwright

// The stretch that ink is reckoned with, both when the sheet is made and when its outcome is shown.
#pragma once

#include "dip/FilmContact.h"

namespace dipwright {

// The mean area stretch of the painted film round each film point (1 where there is none), so that
// the ink's density does not jump from triangle to triangle; linear between the points.
std::vector<float> pointAreaStretches(const DippedFilm& film, const FilmContact& contact);

} // namespace dipwright

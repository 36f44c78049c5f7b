// How far the film that paints is stretched. Film that hangs off the body between adhered and free
// points has no meaning of its own and would drown these figures.
#pragma once

#include "dip/FilmContact.h"

namespace dipwright {

// Final over rest length of the horizontal and vertical constraints that are sides of painted film.
std::vector<float> paintedConstraintStretches(const DippedFilm& film, const FilmContact& contact);

// A film point each: the mean of those of its constraints; 1 where it has none.
std::vector<float> paintedPointStretches(const DippedFilm& film, const FilmContact& contact);

// Area stretch J of the painted film triangles.
std::vector<float> paintedAreaStretches(const DippedFilm& film, const FilmContact& contact);

// A film point each: 1 where painted film meets in it.
std::vector<std::uint8_t> paintedPoints(const DippedFilm& film, const FilmContact& contact);

} // namespace dipwright

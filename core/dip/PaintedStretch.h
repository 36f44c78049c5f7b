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

// How film on the body is compressed: its smaller principal stretch λ2 is below 1. The model lets
// it thicken; real film may fold there (docs/film-model.md, "Measures").
struct Wrinkling {
    std::vector<float> pointStretches; // a film point each: mean λ2 of its painted triangles; or 1
    double area = 0;                   // mm² of flat film with λ2 below wrinkledBelow
    double share = 0;                  // of the painted film
    double least = 1;                  // the smallest λ2
};
inline constexpr float wrinkledBelow =
    0.99f; // a hundredth is within what a film profile is known to
Wrinkling paintedWrinkling(const DippedFilm& film, const FilmContact& contact);

// A film point each: 1 where painted film meets in it.
std::vector<std::uint8_t> paintedPoints(const DippedFilm& film, const FilmContact& contact);

} // namespace dipwright

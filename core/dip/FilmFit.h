// Checks whether a film is large enough for a body, and finds the smallest one that is.
#pragma once

#include "settings/FilmSettings.h"
#include "settings/Immersion.h"

#include <Eigen/Geometry>
#include <QString>
#include <optional>

namespace dipwright {

// Size of a printed film, mm.
struct FilmSize {
    double width = 0, height = 0;
};
// Returns the smallest printed film that extends at least 10 mm past the body, in steps of 10 mm.
// `outline` is the body's outline on the water, its offset included. Returns nothing if that film
// would be larger than largestFilm.
std::optional<FilmSize> smallestFilm(const Eigen::AlignedBox2d& outline, const FilmSettings& film);

inline constexpr double largestFilm = 3000; // mm along each side; limit of film.size_mm

// Returns advice as the last clause of a sentence: to turn this film if it is then as large as
// smallestFilm(), else to choose a larger one.
QString adviceOnFilm(const Eigen::AlignedBox2d& outline, const FilmSettings& film);

// Throws Error if the body reaches past the film on all four sides, because no film could then wrap
// round it. The message ends with adviceOnFilm().
void requireFilmBeyondBody(const Eigen::AlignedBox2d& outline, const FilmSettings& film,
                           const Immersion& immersion);

} // namespace dipwright

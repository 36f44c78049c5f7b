// Whether a film is large enough for a body, and which would be.
#pragma once

#include "settings/FilmSettings.h"
#include "settings/Immersion.h"

#include <Eigen/Geometry>
#include <QString>
#include <optional>

namespace dipwright {

// The least printed film, mm in steps of 10, that reaches 10 mm past a body where it comes down.
// `outline`: of the body on the water, its offset included. Nothing where films are not that large
// (largestFilm).
struct FilmSize {
    double width = 0, height = 0;
};
std::optional<FilmSize> leastFilm(const Eigen::AlignedBox2d& outline, const FilmSettings& film);

inline constexpr double largestFilm = 3000; // mm along each side, as of film.size_mm

// The advice to take such a film, as the end of a sentence.
QString adviceOnFilm(const Eigen::AlignedBox2d& outline, const FilmSettings& film);

// Throws Error, with the film that would do, where the body reaches past the film on all four
// sides: none is left to go round it.
void requireFilmRound(const Eigen::AlignedBox2d& outline, const FilmSettings& film,
                      const Immersion& immersion);

} // namespace dipwright

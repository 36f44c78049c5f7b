// Finds out whether a smaller film would suffice for the dips of a job.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// Printed film left free on each side of the painting film, for film that is drawn in and for
// handling. Assumed, not measured.
inline constexpr Millimetres freeRim{20};
// A format is proposed only if its area is at most this share of the present film's.
inline constexpr double mostAreaShare = 0.75;

// A film format that suffices, and where the bodies then lie.
struct SmallerFilm {
    QString format;                                // its name, "A5"
    Millimetres width{0}, height{0};               // in the proposed orientation
    std::vector<std::array<Millimetres, 2>> moves; // change of each immersion's offset
};

// Returns the used share of the film in the dip that uses most of it (usedShare() in
// dip/LaidFilm.h).
double filmUsed(const JobResult& result);

// Returns the smallest film format that holds the painting film of all dips and a free rim, with
// the bodies moved to its centre. Nothing if no format is small enough, or a barrier holds the
// film.
std::optional<SmallerFilm> smallerFilm(const JobResult& result);

// Sets the project's film to `film` and moves the bodies. The project must have the immersions that
// the film was found for.
void take(Project& project, const SmallerFilm& film);

} // namespace dipwright

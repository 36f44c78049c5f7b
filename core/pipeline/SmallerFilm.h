// Whether a smaller film would do: what of the film the dips of a job use, and the format that they
// need.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// So much of the printed film is left free on each side of what paints, for film that is drawn in
// and for hands to hold; ours.
inline constexpr Millimetres freeRim{20};
// A format is proposed where it is at most so large, of the film that there is.
inline constexpr double mostOfTheFilm = 0.75;

struct SmallerFilm {
    QString format;                                // "A5"; its name
    Millimetres width{0}, height{0};               // as it is to lie
    std::vector<std::array<Millimetres, 2>> moves; // an immersion each: of its offset
};

// The share of the film that the dip uses that uses most of it (usedShare() in dip/LaidFilm.h).
double filmUsed(const JobResult& result);

// The smallest of the film formats that holds what the dips paint, with a free rim, once the bodies
// are moved to its middle; nothing where there is none so much smaller, or a barrier holds the
// film.
std::optional<SmallerFilm> smallerFilm(const JobResult& result);

// Gives the project that film, and moves the bodies over it. The project has the immersions that
// the film was found for.
void take(Project& project, const SmallerFilm& film);

} // namespace dipwright

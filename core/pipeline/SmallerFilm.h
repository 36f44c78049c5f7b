// Finds out whether a smaller film would suffice for the dips of a job.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// Width of the rim that is kept round the film that paints. It leaves room for handling, and for
// film that is pulled inwards. Assumed, not measured.
inline constexpr Millimetres freeRim{20};
// A format is proposed only if its area is at most this share of the present film's.
inline constexpr double mostAreaShare = 0.75;

// A film format that suffices, and the new positions of the bodies.
struct SmallerFilm {
    QString format;                                // name of the format, "A5"
    Millimetres width{0}, height{0};               // size in the proposed orientation
    std::vector<std::array<Millimetres, 2>> moves; // change of each immersion's offset
};

// Returns which share of the film is used, in the dip that uses the most (usedShare() in
// dip/LaidFilm.h).
double filmUsed(const JobResult& result);

// Returns the smallest film format with room for the film that paints, in all dips, and for
// freeRim. The bodies move to the format's centre. None if no format is small enough, if a barrier
// holds the film, if a body is not dipped straight down, or if the verdict says that a dip comes
// too near to the film's edge.
std::optional<SmallerFilm> smallerFilm(const JobResult& result);

// Sets the project's film to `film` and moves the bodies. The project must have the same immersions
// as the job for which `film` was found.
void take(Project& project, const SmallerFilm& film);

} // namespace dipwright

// Fits how fast floating film keeps growing, from its swell at several times (docs/film-model.md,
// "Swell, relaxation and edges").
#pragma once

#include "inspection/FlatFilm.h"

#include <vector>

namespace dipwright {

struct SwellAt {
    double seconds = 0; // since the film was laid on the water
    Measured x, y;
};

enum class GrowthKnown {
    No,       // fewer than three times
    None,     // no growth that the photos can show
    RateOnly, // it grew at the same rate until the last time
    Both
};

// The swell when the dip begins, and the growth from then on: t seconds later the film is longer by
// the factor 1 + limit · (1 − exp(−rate · t / limit)). Rate and limit are 0 if they are not known.
struct GrowthFit {
    Measured swellX, swellY;
    GrowthKnown known = GrowthKnown::No;
    Measured rate, limit; // 1/s, and a share of the length
};

// `begin` is the time at which the dip begins, in seconds. `moments` has at least one entry. With
// fewer than three times, the swell is that of the time nearest to `begin`, or the mean of equally
// near ones.
GrowthFit fitGrowth(const std::vector<SwellAt>& moments, double begin);

} // namespace dipwright

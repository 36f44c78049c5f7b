// How fast floating film goes on growing, by its swell at several moments
// (docs/film-model.md, "Swell, relaxation and edges").
#pragma once

#include "inspection/FlatFilm.h"

#include <vector>

namespace dipwright {

struct SwellAt {
    double seconds = 0; // since the film was laid on the water
    Measured x, y;
};

enum class GrowthKnown {
    No,       // fewer than three moments
    None,     // it does not grow by more than the photos can tell
    RateOnly, // it still grew as fast at the last moment as at the first
    Both
};

// The swell when the dip begins, and what follows: t seconds later the film is
// 1 + limit · (1 − exp(−rate · t / limit)) times as long.
struct GrowthFit {
    Measured swellX, swellY;
    GrowthKnown known = GrowthKnown::No;
    Measured rate, limit; // 1/s, and a share of the length; both 0 but for Both and RateOnly's rate
};

// `begin`: seconds at which the dip begins. At least one moment. Fewer than three: the swell is
// that of the moment nearest to `begin`, or the mean of those that are as near.
GrowthFit fitGrowth(const std::vector<SwellAt>& moments, double begin);

} // namespace dipwright

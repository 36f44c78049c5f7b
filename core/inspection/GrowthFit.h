// Fits how fast floating film keeps growing, from its swell at several times (docs/film-model.md,
// "Swell, relaxation and edges").
#pragma once

#include "inspection/FlatFilm.h"

#include <QString>
#include <vector>

namespace dipwright {

struct SwellAt {
    double seconds = 0; // since the film was laid on the water
    Measured x, y;
};

enum class GrowthKnowledge {
    No,       // not measured: fewer than three times
    None,     // the photos rule out growth of more than 0.5 % while they were taken
    RateOnly, // the film grew at a constant rate until the last of the times
    Both      // rate and limit are known
};

// The swell when the dip begins, and the growth from then on. After t more seconds the film is
// longer by the factor 1 + limit · (1 − exp(−rate · t / limit)). An unknown rate or limit is 0.
struct GrowthFit {
    Measured swellX, swellY;
    GrowthKnowledge known = GrowthKnowledge::No;
    Measured rate, limit; // rate in 1/s, limit as a share of the length
};

// Fits swell and growth. `begin` is the time at which the dip begins, in seconds. `moments` has at
// least one entry. With fewer than three times, the swell comes from the moment nearest to `begin`,
// or from the mean of equally near moments. Throws Error, naming `where`, if the film shrinks with
// time, or if the moments fit no law of growth.
GrowthFit fitGrowth(const std::vector<SwellAt>& moments, double begin, const QString& where);

} // namespace dipwright

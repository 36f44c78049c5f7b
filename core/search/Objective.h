// Rates poses by their measures (docs/pose-search.md, "The objective").
#pragma once

#include "settings/SearchSettings.h"

namespace dipwright {

// Returns how well film with the stretches λ1 ≥ λ2 shows its picture: 1 for λ1 ≤ 1.2 and λ2 ≥ 0.7,
// falling linearly to 0 at λ1 = 2.5 and at λ2 = 0.2.
double printQuality(double larger, double smaller);

// Returns the weighted mean of the measures' ratings, 0 … 1. The seam counts only for two dips
// (appliesToTwoDips), relative to `equator`: the circumference of a ball of equal surface, mm.
double objective(const PoseMeasures& measures, const SearchSettings& settings, double equator);
// Returns the sum of the amounts by which limits are missed, each relative to its limit; 0 if all
// limits are kept.
double limitsMissed(const PoseMeasures& measures, const SearchSettings& settings);

} // namespace dipwright

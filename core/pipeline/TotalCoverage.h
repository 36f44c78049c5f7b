// How much of the body all immersions paint together.
#pragma once

#include "pipeline/Pipeline.h"

namespace dipwright {

// The share of the surface that at least one immersion paints, by samples spread evenly over it.
// One immersion: its own coverage.
double totalCoverage(const std::vector<ImmersionResult>& immersions, const Progress& progress);

} // namespace dipwright

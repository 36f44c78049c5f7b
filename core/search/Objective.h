// How good a pose is, by what was measured of it (docs/pose-search.md, "The objective").
#pragma once

#include "settings/SearchSettings.h"

namespace dipwright {

// How well film that is stretched by λ1 ≥ λ2 shows its picture: 1 up to λ1 = 1.2 and down to
// λ2 = 0.7, falling to 0 at 2.5 and at 0.2.
double printQuality(double larger, double smaller);

// 0 … 1: the mean of how good each measure is, by the weights. The join counts for two dips only
// (isOfTwoDips), against `equator`, mm: the girth of a ball with the body's surface.
double objective(const PoseMeasures& measures, const SearchSettings& settings, double equator);
// How far the limits are missed, each as a share of the limit, together; 0: all are kept.
double limitsMissed(const PoseMeasures& measures, const SearchSettings& settings);

} // namespace dipwright

#include "search/Objective.h"

#include <algorithm>

namespace dipwright {
namespace {

// Stretches with the best and the worst rating. At the usual tear stretch (process.tear_stretch),
// film no longer shows its picture.
constexpr double goodStretch = 1.2, uselessStretch = 4;
constexpr double longestSeam = 2; // seam length with the worst rating, relative to the equator
constexpr double leastLimitScale = 0.01; // least divisor, for limits near 0

// Returns 1 at `good` and 0 at `bad`, linear between.
double ramp(double value, double good, double bad) {
    return std::clamp((value - bad) / (good - bad), 0.0, 1.0);
}

double goodness(Measure measure, double value, double equator) {
    switch (measure) {
    case Measure::Quality:
    case Measure::Coverage:
    case Measure::Certain:
        return value;
    case Measure::Stretch:
        return ramp(value, goodStretch, uselessStretch);
    case Measure::Join:
        return ramp(value, 0, longestSeam * equator);
    case Measure::Wrinkled:
    case Measure::Torn:
    case Measure::TrappedAir:
    case Measure::Narrow:
    case Measure::FilmUsed:
        break;
    }
    return 1 - value;
}

} // namespace

double printQuality(double larger, double smaller) {
    return ramp(larger, 1.2, 2.5) * ramp(smaller, 0.7, 0.2);
}

double objective(const PoseMeasures& measures, const SearchSettings& settings, double equator) {
    double sum = 0, weights = 0;
    for (const Measure measure : allMeasures()) {
        if (!appliesToTwoDips(measure) || settings.immersions == 2) {
            const double weight = settings.aims.weights[measure];
            sum += weight * goodness(measure, measures[measure], equator);
            weights += weight;
        }
    }
    return sum / weights;
}

double limitsMissed(const PoseMeasures& measures, const SearchSettings& settings) {
    double missed = 0;
    for (const Measure measure : allMeasures()) {
        if (const std::optional<double>& limit = settings.aims.limits[measure]) {
            const double over =
                isHigherBetter(measure) ? *limit - measures[measure] : measures[measure] - *limit;
            missed += std::max(over, 0.0) / std::max(*limit, leastLimitScale);
        }
    }
    return missed;
}

} // namespace dipwright

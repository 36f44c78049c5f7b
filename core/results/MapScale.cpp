#include "results/MapScale.h"

#include "base/NumberText.h"
#include "results/ColourMap.h"
#include "results/Results.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

double MapScale::share(double value) const {
    return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

QColor MapScale::colour(double place) const {
    return mapColour(map, lowerHalf ? place / 2 : place);
}

QColor MapScale::past() const {
    return colourAbove(map);
}

QString MapScale::text(double value) const {
    int decimals = 1; // enough to tell the steps apart
    for (double ten = 10 * step; std::abs(ten - std::round(ten)) > 1e-6 * ten; ten *= 10) {
        ++decimals;
    }
    return numberText(value, decimals);
}

double roundedUp(double least) {
    const double decade = std::pow(10, std::floor(std::log10(least)));
    for (double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= least) {
            return factor * decade;
        }
    }
    return 10 * decade;
}

double niceStep(double span) {
    return roundedUp(span / 6);
}

double highestOf(std::vector<float> values) {
    constexpr double outliers = 0.01;
    std::sort(values.begin(), values.end());
    return double(values[std::size_t(std::ceil((1 - outliers) * double(values.size() - 1)))]);
}

MapScale stretchScale(std::vector<float> values) {
    constexpr double least = 0.02; // a smaller range would show only noise
    constexpr double outliers = 0.002;
    std::sort(values.begin(), values.end());
    const auto last = double(values.size() - 1);
    const double lowest = values[std::size_t(std::floor(outliers * last))];
    const double highest = values[std::size_t(std::ceil((1 - outliers) * last))];
    MapScale scale;
    const double above = std::clamp(highest - 1, least, 9.0);
    const double below = 1 - lowest;
    if (below > 0.1 * above && below > least / 2) {
        const double reach = std::min(std::max(above, below), 1.0); // stretch is never below 0
        scale.step = niceStep(2 * reach);
        const double end = std::ceil(reach / scale.step - 1e-6) * scale.step;
        scale.low = 1 - end;
        scale.high = 1 + end;
        scale.map = QStringLiteral("balance");
    } else {
        scale.step = niceStep(above);
        scale.high = 1 + std::ceil(above / scale.step - 1e-6) * scale.step;
        scale.map = QStringLiteral("lagoon");
    }
    return scale;
}

MapScale changeScale(const std::vector<float>& values, double limit, double least) {
    constexpr double mostLimits = 4;
    const double highest = std::max(least, highestOf(values));
    MapScale scale;
    scale.step = highest < limit ? niceStep(highest) : limit;
    scale.low = 0;
    const double steps = std::ceil(highest / scale.step - 1e-6);
    scale.high = scale.step * (highest < limit ? steps : std::min(steps, mostLimits));
    scale.map = QStringLiteral("lagoon");
    scale.hasColourAbove = double(*std::max_element(values.begin(), values.end())) > scale.high;
    return scale;
}

} // namespace dipwright

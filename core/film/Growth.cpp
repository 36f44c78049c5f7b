#include "film/Growth.h"

#include <cmath>

namespace dipwright {

bool grows(const solver::Settings& settings) {
    return settings.growthRate > 0 && settings.growthLimit > 0;
}

double grownLength(double seconds, const solver::Settings& settings) {
    const double rate = settings.growthRate, limit = settings.growthLimit;
    return grows(settings) ? 1 - limit * std::expm1(-rate * seconds / limit) : 1.0;
}

} // namespace dipwright

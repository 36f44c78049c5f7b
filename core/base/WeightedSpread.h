// Mean and spread of weighted values.
#pragma once

#include <algorithm>
#include <cmath>

namespace dipwright {

struct WeightedSpread {
    double weight = 0, sum = 0, squares = 0;
    void add(double value, double by = 1) {
        weight += by;
        sum += by * value;
        squares += by * value * value;
    }
    // Returns the standard deviation; 0 without values.
    double deviation() const {
        const double mean = weight > 0 ? sum / weight : 0;
        return weight > 0 ? std::sqrt(std::max(0.0, squares / weight - mean * mean)) : 0;
    }
};

} // namespace dipwright

// Compares the contrast of a picture as it shows with that of the picture that is wanted.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

// Collects places of both pictures. Contrast is the standard deviation of the lightness L*
// (texture/LinearLight.h, labOf()).
class ContrastKept {
public:
    // The lightness at one place, 0 … 100, and the weight of the place, such as its area.
    void add(double wanted, double shown, double weight = 1) {
        wanted_.add(wanted, weight);
        shown_.add(shown, weight);
    }
    // Returns the contrast that shows, divided by the contrast that is wanted. NaN if less than 0.5
    // is wanted, because such a picture is plain.
    double share() const {
        constexpr double leastContrast = 0.5;
        return wanted_.deviation() > leastContrast ? shown_.deviation() / wanted_.deviation()
                                                   : std::numeric_limits<double>::quiet_NaN();
    }

private:
    struct Spread {
        double weight = 0, sum = 0, squares = 0;
        void add(double value, double by) {
            weight += by;
            sum += by * value;
            squares += by * value * value;
        }
        double deviation() const {
            const double mean = weight > 0 ? sum / weight : 0;
            return weight > 0 ? std::sqrt(std::max(0.0, squares / weight - mean * mean)) : 0;
        }
    };
    Spread wanted_, shown_;
};

} // namespace dipwright

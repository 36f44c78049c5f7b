// Finds the root of a function between two places.
#pragma once

#include "common/HostDevice.h"

#include <cmath>

namespace dipwright::numerics {

// The most values that rootBetween() computes. A smooth function needs about three. Where rounding
// hides the root, more would change nothing.
inline constexpr int rootSteps = 12;

// A root is found where the value is this share of the difference between both ends.
inline constexpr double rootFound = 1e-5;

// Returns a share t from 0 to 1 at which valueAt(t) is about 0, by the method of Anderson and
// Björck (BIT 13, 1973): regula falsi that lowers the value at an end which stays twice in
// succession. It needs few values at a kink, too. `atStart` is the value at 0 and `atEnd` the value
// at 1; one must be positive, the other must not.
template <typename Real, typename Value>
DIPWRIGHT_HOST_DEVICE inline Real rootBetween(const Value& valueAt, Real atStart, Real atEnd) {
    const Real closeEnough = Real(rootFound) * std::abs(atEnd - atStart);
    Real start(0), end(1), root(0), before(0);
    for (int step = 0; step < rootSteps; ++step) {
        root = start + (end - start) * (atStart / (atStart - atEnd));
        const Real value = valueAt(root);
        if (std::abs(value) < closeEnough) {
            break;
        }
        const bool replacesStart = (value > Real(0)) == (atStart > Real(0));
        if (before * value > Real(0)) { // `before` is the value at the end that is replaced
            const Real lowered = Real(1) - value / before;
            (replacesStart ? atEnd : atStart) *= lowered > Real(0) ? lowered : Real(0.5);
        }
        (replacesStart ? start : end) = root;
        (replacesStart ? atStart : atEnd) = value;
        before = value;
    }
    return root;
}

} // namespace dipwright::numerics

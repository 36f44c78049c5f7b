// Finds the root of a function between two places.
#pragma once

#include "common/HostDevice.h"

#include <cmath>

namespace dipwright::numerics {

// The most values that rootBetween() computes. A smooth function needs two or three, one with a
// sharp kink about twelve.
inline constexpr int rootSteps = 20;

// The search ends where |value| is below this share of the difference between both ends' values.
inline constexpr double rootFound = 1e-5;

// Returns a share t from 0 to 1 at which valueAt(t) is about 0. The method is Chandrupatla's
// (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where the last three
// values are monotonic enough for it, otherwise bisection. Unlike there, the first trial is linear.
// `atStart` is the value at 0 and `atEnd` the value at 1; one must be positive, the other must not.
// Returns the last t for which it called valueAt().
template <typename Real, typename Value>
DIPWRIGHT_HOST_DEVICE inline Real rootBetween(const Value& valueAt, Real atStart, Real atEnd) {
    const Real closeEnough = Real(rootFound) * std::abs(atEnd - atStart);
    // The newest trial and the nearest one on the other side of the root.
    Real newest(1), other(0), atNewest = atEnd, atOther = atStart;
    Real root = atStart / (atStart - atEnd);
    for (int step = 1;; ++step) {
        const Real value = valueAt(root);
        if (std::abs(value) < closeEnough || step == rootSteps) {
            return root;
        }
        Real dropped = newest, atDropped = atNewest;
        if ((value > Real(0)) != (atNewest > Real(0))) {
            dropped = other;
            atDropped = atOther;
            other = newest;
            atOther = atNewest;
        }
        newest = root;
        atNewest = value;
        const Real place = (newest - other) / (dropped - other);
        const Real height = (atNewest - atOther) / (atDropped - atOther);
        const bool isMonotonic =
            height * height < place && (Real(1) - height) * (Real(1) - height) < Real(1) - place;
        // The way from the newest trial to the other, as a share.
        const Real way =
            isMonotonic
                ? atNewest / (atOther - atNewest) * (atDropped / (atOther - atDropped)) +
                      (dropped - newest) / (other - newest) * (atNewest / (atDropped - atNewest)) *
                          (atOther / (atDropped - atOther))
                : Real(0.5);
        root = newest + (other - newest) * way;
    }
}

} // namespace dipwright::numerics

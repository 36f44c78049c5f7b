// How far the film's equilibrium is pursued (Newton's method with conjugate gradients), the same on
// every device.
#pragma once

namespace dipwright::numerics {

inline constexpr int maximumNewtonSteps = 12;
inline constexpr int maximumConjugateSteps = 40;
inline constexpr int maximumShortenings = 6; // of one Newton step, by half each

} // namespace dipwright::numerics

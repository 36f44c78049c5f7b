// The film in the water plane at rest under its forces: Newton's method with a line search, warm
// started by the caller; and conjugate gradients for its linear systems. Written once for all
// devices (FilmBackend.h); the limits are in Tolerances.h.
#pragma once

#include "production/formulas/FilmBackend.h"

#include <cmath>

namespace dipwright::numerics {

namespace detail {

// Adds the Newton step to the displacement, shortened until the forces shrink. Where no length
// helps, the whole step is taken all the same: the forces may have to grow on the way past a
// crease. `now` becomes the force then. False where the step is no number.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM inline bool searchAlongStep(Film& film, typename Film::Real drag, FilmForce& now) {
    using Real = typename Film::Real;
    constexpr NewtonLimits limits = Film::newtonLimits();
    const double longest = film.startOfStep();
    if (!std::isfinite(longest)) {
        return false;
    }
    const double most = longestNewtonStep * std::fmax(film.model().spacingX, film.model().spacingZ);
    const double whole = std::fmin(1.0, most / std::fmax(longest, shortestNewtonStep));
    const double before = now.left;
    double length = whole;
    for (int attempt = 0; attempt <= limits.shortenings; ++attempt, length /= 2) {
        const bool isLast = attempt == limits.shortenings;
        now = film.forceAlong(Real(isLast ? whole : length), drag);
        if (now.left <= before * (1 - limits.sufficientDecrease * length)) {
            break;
        }
    }
    return true;
}

} // namespace detail

// Moves the free points until the forces left on them are at most the model's `residual` times the
// elastic forces in the film; or as far as that goes, to the least forces met on the way.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM inline void findEquilibrium(Film& film, typename Film::Real drag) {
    constexpr NewtonLimits limits = Film::newtonLimits();
    const double floor = limits.flatForce * std::sqrt(double(pointCount(film.model())));
    FilmForce now = film.force(drag);
    double best = now.left;
    film.keepBest();
    for (int iteration = 0; iteration < limits.newtonSteps; ++iteration) {
        const double allowed = std::fmax(film.model().residual * now.elastic, floor);
        if (now.left <= allowed) {
            return;
        }
        film.solveLinear(
            drag, now.left,
            std::fmax(limits.linearShareOfAllowed * allowed, limits.linearShareOfLeft * now.left));
        if (!detail::searchAlongStep(film, drag, now)) {
            break;
        }
        if (now.left < best) {
            best = now.left;
            film.keepBest();
        }
    }
    film.takeBest();
}

// Solves H · step = −forces to a residual of `tolerance`, or as far as it goes: crossing triangles
// make the Hessian H slightly unsymmetric. `start`: the residual of no step.
template <ConjugateBackend Film>
DIPWRIGHT_TEAM inline void conjugateGradients(Film& film, typename Film::Real drag, double start,
                                              double tolerance) {
    using Real = typename Film::Real;
    film.startLinear();
    double before = 0;
    for (int iteration = 0; iteration < mostConjugateSteps; ++iteration) {
        const double now = film.precondition();
        if (!(now > 0)) {
            return;
        }
        const Real keep = before > 0 ? Real(now / before) : Real(0);
        before = now;
        const double curvature = film.curvature(drag, keep, iteration);
        if (!(curvature > leastCurvature * now)) {
            return;
        }
        const double left = film.advance(Real(now / curvature), iteration);
        if (left <= tolerance || !(left < mostResidualGrowth * start)) {
            return;
        }
    }
}

} // namespace dipwright::numerics

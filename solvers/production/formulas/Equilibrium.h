// Finds the film's equilibrium in the water plane with Newton's method and a line search. The
// caller provides a warm start. The linear systems are solved by GMRES, because triangles on the
// contact line make them unsymmetric. The code is the same for all devices (FilmBackend.h).
// Tolerances.h has the limits.
#pragma once

#include "production/formulas/FilmBackend.h"

#include <cmath>

namespace dipwright::numerics {

namespace detail {

// Searches for a length of the Newton step that reduces the forces. If there is one, moves the film
// by this length and returns true. Otherwise moves it by the whole step and returns false. `now` is
// the force at the new displacement.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM DIPWRIGHT_CALLED bool searchAlongStep(Film& film, typename Film::Real drag,
                                                     FilmForce& now) {
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
    for (int attempt = 0; attempt < limits.shortenings; ++attempt, length /= 2) {
        now = film.forceAlong(Real(length), drag);
        if (now.left <= before * (1 - limits.sufficientDecrease * length)) {
            return true;
        }
    }
    now = film.forceAlong(Real(whole), drag);
    return false;
}

// Takes one Newton step with the true derivative. This can fail, because film that gathers or
// rotates gives way in some directions. Then the film is made stiffer step by step, as if it stuck
// to the water. Stiffening shortens the step and turns it downhill (Levenberg–Marquardt).
// `stiffening` is relative to the film's shear stiffness and is kept between steps. `prepared` is
// the stiffening for which the linear solver was prepared last; negative: for none.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM inline void newtonStep(Film& film, typename Film::Real drag, double tolerance,
                                      double& stiffening, double& prepared, FilmForce& now) {
    using Real = typename Film::Real;
    const double before = now.left;
    const auto prepare = [&](double stiffer) {
        if (prepared != stiffer) {
            film.prepareLinear(drag + Real(stiffer));
            prepared = stiffer;
        }
    };
    for (;;) {
        prepare(stiffening);
        film.solveLinear(drag + Real(stiffening), Tangent::True, before, tolerance);
        if (searchAlongStep(film, drag, now)) {
            stiffening = stiffening > leastStiffening ? stiffening / stiffeningFactor : 0;
            return;
        }
        now = film.forceAlong(Real(0), drag);
        if (stiffening >= mostStiffening) {
            break;
        }
        stiffening = std::fmax(leastStiffening, stiffening * stiffeningFactor);
    }
    // If that fails too, takes the whole step downhill. To get past a crease, the film may have
    // to pass through states with larger forces.
    prepare(0);
    film.solveLinear(drag, Tangent::Projected, before, tolerance);
    searchAlongStep(film, drag, now);
}

} // namespace detail

// The result of a search for equilibrium: the remaining forces on the free points, relative to the
// elastic forces in the film (0 if these are zero), and whether this ratio reaches the required
// residual.
struct EquilibriumResult {
    double left = 0;
    bool isReached = true;
};

// Moves the free points until the remaining forces are at most the model's `residual` times the
// elastic forces, or zero within the precision of the numbers. If the search fails, goes back to
// the step that left the smallest forces, and restores its displacement. `farthest`, in mm, is the
// largest displacement of a point from rest, or the longest cell edge if that is larger.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM DIPWRIGHT_CALLED EquilibriumResult findEquilibrium(Film& film,
                                                                  typename Film::Real drag,
                                                                  double farthest) {
    constexpr NewtonLimits limits = Film::newtonLimits();
    const double floor =
        limits.flatForce * std::fmax(1.0, farthest) * std::sqrt(double(pointCount(film.model())));
    FilmForce now = film.force(drag), best = now;
    double stiffening = 0, prepared = -1;
    int sinceBest = 0;
    film.keepBest();
    for (int iteration = 0;
         iteration < limits.newtonSteps && sinceBest < limits.mostStepsWithoutReduction;
         ++iteration) {
        const double allowed = std::fmax(film.model().residual * now.elastic, floor);
        if (now.left <= allowed) {
            return {now.elastic > 0 ? now.left / now.elastic : 0, true};
        }
        detail::newtonStep(film, drag,
                           std::fmax(limits.linearShareOfAllowed * allowed,
                                     limits.linearShareOfRemaining * now.left),
                           stiffening, prepared, now);
        if (!std::isfinite(now.left)) {
            break;
        }
        sinceBest = now.left < limits.gain * best.left ? 0 : sinceBest + 1;
        if (now.left < best.left) {
            best = now;
            film.keepBest();
        }
    }
    film.takeBest();
    return {best.elastic > 0 ? best.left / best.elastic : 0,
            best.left <= std::fmax(film.model().residual * best.elastic, floor)};
}

namespace detail {

// Adds column `k` (k + 2 numbers) to the least-squares problem. Returns the new residual; NaN if
// the column's length is NaN.
DIPWRIGHT_HOST_DEVICE inline double takeColumn(GmresProblem& problem, int k) {
    double* column = problem.matrix[k];
    DIPWRIGHT_ROLLED
    for (int i = 0; i < k; ++i) {
        const double upper = problem.cosine[i] * column[i] + problem.sine[i] * column[i + 1];
        column[i + 1] = problem.cosine[i] * column[i + 1] - problem.sine[i] * column[i];
        column[i] = upper;
    }
    const double size = std::sqrt(column[k] * column[k] + column[k + 1] * column[k + 1]);
    // With `size > 0`, NaN would count as an exact solution.
    problem.cosine[k] = size == 0 ? 1 : column[k] / size;
    problem.sine[k] = size == 0 ? 0 : column[k + 1] / size;
    column[k] = size;
    problem.right[k + 1] = -problem.sine[k] * problem.right[k];
    problem.right[k] *= problem.cosine[k];
    return std::fabs(problem.right[k + 1]);
}

// Computes the weights of the first `count` basis vectors that give the smallest residual. Returns
// that residual.
DIPWRIGHT_HOST_DEVICE inline double solveTriangular(GmresProblem& problem, int count) {
    DIPWRIGHT_ROLLED
    for (int i = count - 1; i >= 0; --i) {
        double sum = problem.right[i];
        DIPWRIGHT_ROLLED
        for (int j = i + 1; j < count; ++j) {
            sum -= problem.matrix[j][i] * problem.weights[j];
        }
        problem.weights[i] = problem.matrix[i][i] > 0 ? sum / problem.matrix[i][i] : 0;
    }
    return std::fabs(problem.right[count]);
}

} // namespace detail

// Solves H · step = −forces by GMRES to a residual of `tolerance`, or as far as mostBasisVectors
// allow. Preconditioning from the right (Saad, Iterative Methods for Sparse Linear Systems,
// algorithm 9.5) makes the residual of GMRES the true residual. `start` is the residual of a zero
// step.
template <GmresBackend Film>
DIPWRIGHT_TEAM inline void solveGmres(Film& film, typename Film::Real drag, Tangent tangent,
                                      double start, double tolerance) {
    using Real = typename Film::Real;
    film.inSmallProblem([&](GmresProblem& problem) { return problem.right[0] = start; });
    film.startBasis(Real(start > 0 ? 1 / start : 0));
    int count = 0;
    for (double left = start; count < mostBasisVectors && left > tolerance; ++count) {
        film.extendBasis(count, drag, tangent);
        ++film.state().equilibrium.linearIterations;
        left = film.inSmallProblem(
            [&](GmresProblem& problem) { return detail::takeColumn(problem, count); });
        if (!std::isfinite(left)) {
            break; // without this column
        }
    }
    film.inSmallProblem(
        [&](GmresProblem& problem) { return detail::solveTriangular(problem, count); });
    film.setStep(count);
}

} // namespace dipwright::numerics

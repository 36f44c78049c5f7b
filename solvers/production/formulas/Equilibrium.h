// The film in the water plane at rest under its forces: Newton's method with a line search, warm
// started by the caller; and the method of least residuals (GMRES) for its linear systems, which
// triangles on the contact line make unsymmetric. Written once for all devices (FilmBackend.h); the
// limits are in Tolerances.h.
#pragma once

#include "production/formulas/FilmBackend.h"

#include <cmath>

namespace dipwright::numerics {

namespace detail {

// Whether some length of the Newton step makes the forces shrink: then the displacement has gone by
// it and `now` is the force there. Else both are as after the whole step.
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
    for (int attempt = 0; attempt < limits.shortenings; ++attempt, length /= 2) {
        now = film.forceAlong(Real(length), drag);
        if (now.left <= before * (1 - limits.sufficientDecrease * length)) {
            return true;
        }
    }
    now = film.forceAlong(Real(whole), drag);
    return false;
}

// One Newton step, by the true derivative. Where that leads nowhere (film that gathers, or turns,
// has directions in which it gives way), the film is taken to be stiffer by and by, as if it
// stuck to the water, which makes the step shorter and turns it downhill (Levenberg, Marquardt).
// `stiffening`, over the film's shear stiffness, is kept from step to step.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM inline void newtonStep(Film& film, typename Film::Real drag, double tolerance,
                                      double& stiffening, FilmForce& now) {
    using Real = typename Film::Real;
    const double before = now.left;
    for (;;) {
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
    // Where that does not help either, the whole step downhill is taken all the same: the forces
    // may have to grow on the way past a crease.
    film.solveLinear(drag, Tangent::Projected, before, tolerance);
    searchAlongStep(film, drag, now);
}

} // namespace detail

// How a search for equilibrium has ended: the forces left on the free points over the elastic
// forces in the film (0 where these are nothing), and whether that is as little as asked for.
struct FoundEquilibrium {
    double left = 0;
    bool isReached = true;
};

// Moves the free points until the forces left on them are at most the model's `residual` times the
// elastic forces in the film, or nothing to the precision of their numbers; or as far as that goes,
// to the least forces met after a step. `farthest`: mm that a point has come from its rest, or
// the longest cell has, at most.
template <FilmEquilibrium Film>
DIPWRIGHT_TEAM inline FoundEquilibrium findEquilibrium(Film& film, typename Film::Real drag,
                                                       double farthest) {
    constexpr NewtonLimits limits = Film::newtonLimits();
    const double floor =
        limits.flatForce * std::fmax(1.0, farthest) * std::sqrt(double(pointCount(film.model())));
    FilmForce now = film.force(drag), best = now;
    double stiffening = 0;
    int sinceBest = 0;
    film.keepBest();
    for (int iteration = 0; iteration < limits.newtonSteps && sinceBest < limits.stepsWithoutGain;
         ++iteration) {
        const double allowed = std::fmax(film.model().residual * now.elastic, floor);
        if (now.left <= allowed) {
            return {now.elastic > 0 ? now.left / now.elastic : 0, true};
        }
        if (iteration == 0) {
            film.prepareLinear(drag);
        }
        detail::newtonStep(
            film, drag,
            std::fmax(limits.linearShareOfAllowed * allowed, limits.linearShareOfLeft * now.left),
            stiffening, now);
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

// Takes column `k` (k + 2 numbers) into the least-squares problem. The residual then.
DIPWRIGHT_HOST_DEVICE inline double takeColumn(LeastResiduals& problem, int k) {
    double* column = problem.matrix[k];
    for (int i = 0; i < k; ++i) {
        const double upper = problem.cosine[i] * column[i] + problem.sine[i] * column[i + 1];
        column[i + 1] = problem.cosine[i] * column[i + 1] - problem.sine[i] * column[i];
        column[i] = upper;
    }
    const double size = std::sqrt(column[k] * column[k] + column[k + 1] * column[k + 1]);
    problem.cosine[k] = size > 0 ? column[k] / size : 1;
    problem.sine[k] = size > 0 ? column[k + 1] / size : 0;
    column[k] = size;
    problem.right[k + 1] = -problem.sine[k] * problem.right[k];
    problem.right[k] *= problem.cosine[k];
    return std::fabs(problem.right[k + 1]);
}

// The weights of the first `count` basis vectors with the least residual, which it returns.
DIPWRIGHT_HOST_DEVICE inline double solveTriangular(LeastResiduals& problem, int count) {
    for (int i = count - 1; i >= 0; --i) {
        double sum = problem.right[i];
        for (int j = i + 1; j < count; ++j) {
            sum -= problem.matrix[j][i] * problem.weights[j];
        }
        problem.weights[i] = problem.matrix[i][i] > 0 ? sum / problem.matrix[i][i] : 0;
    }
    return std::fabs(problem.right[count]);
}

} // namespace detail

// Solves H · step = −forces to a residual of `tolerance`, or as far as it goes, by restarted GMRES
// preconditioned from the right (Saad, Iterative Methods for Sparse Linear Systems, algorithm 9.5):
// so the residual that it sees is the true one. `start`: the residual of no step.
template <LeastResidualBackend Film>
DIPWRIGHT_TEAM inline void leastResiduals(Film& film, typename Film::Real drag, Tangent tangent,
                                          double start, double tolerance) {
    using Real = typename Film::Real;
    film.startLinear();
    double left = start;
    for (int restart = 0; restart <= mostRestarts && left > tolerance; ++restart) {
        film.inSmallProblem([&](LeastResiduals& problem) { return problem.right[0] = left; });
        film.startBasis(Real(1 / left));
        int count = 0;
        while (count < mostBasisVectors && left > tolerance) {
            film.extendBasis(count, drag, tangent);
            ++film.state().equilibrium.linearIterations;
            left = film.inSmallProblem(
                [&](LeastResiduals& problem) { return detail::takeColumn(problem, count); });
            ++count;
            if (!std::isfinite(left)) {
                return;
            }
        }
        film.inSmallProblem(
            [&](LeastResiduals& problem) { return detail::solveTriangular(problem, count); });
        film.addToStep(count);
        if (left > tolerance && restart < mostRestarts) {
            left = film.linearResidual(drag, tangent);
        }
    }
}

} // namespace dipwright::numerics

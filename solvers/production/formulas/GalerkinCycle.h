// What a multigrid cycle for the film's stiffness consists of, whatever computes it.
//
// The operator of the finest grid is put together of the stiffness of every triangle as it is now
// (EdgeStiffness.h): drawn out, gathered, turned, crossing the contact line, beside film that is
// held. Every second point of a grid stays in the next coarser one, with bilinear interpolation P
// between them, and the coarse operator is PᵀKP (Galerkin): so the coarse grids know what a
// constant stencil of the flat film does not, where film is soft and what holds it. Smoothing is by
// Chebyshev polynomials over the points' own 2 × 2 blocks, the same for any number of threads.
#pragma once

#include <array>

namespace dipwright::numerics::galerkin {

// Smoothing takes care of the part of the spectrum (of block⁻¹·stiffness) between these.
inline constexpr double largestEigenvalue = 2.4;
inline constexpr double smallestSmoothed = 0.4;
inline constexpr int smoothingDegree = 2;
inline constexpr int coarsestDegree = 16;
// A point's own block counts as singular below this determinant, over the square of its trace.
inline constexpr float leastDeterminant = 1e-4f;
inline constexpr int coarsestPoints = 5; // along the shorter edge: no coarser

// One step of the polynomial: direction ← keep·direction + gain·block⁻¹·residual, added to the
// result.
struct ChebyshevStep {
    float keep = 0, gain = 0;
};

template <int degree>
constexpr std::array<ChebyshevStep, std::size_t(degree)> chebyshev() {
    constexpr double centre = (largestEigenvalue + smallestSmoothed) / 2;
    constexpr double radius = (largestEigenvalue - smallestSmoothed) / 2;
    std::array<ChebyshevStep, std::size_t(degree)> steps{};
    steps[0] = {0, float(1 / centre)};
    double rho = radius / centre;
    for (std::size_t k = 1; k < std::size_t(degree); ++k) {
        const double next = 1 / (2 * centre / radius - rho);
        steps[k] = {float(next * rho), float(2 * next / radius)};
        rho = next;
    }
    return steps;
}

inline constexpr std::array<ChebyshevStep, std::size_t(smoothingDegree)> smoothingSteps =
    chebyshev<smoothingDegree>();
inline constexpr std::array<ChebyshevStep, std::size_t(coarsestDegree)> coarsestSteps =
    chebyshev<coarsestDegree>();

constexpr bool isCoarsest(int columns, int rows) {
    return (columns < rows ? columns : rows) <= coarsestPoints;
}
// Coarse point c lies on fine point 2c; of an even number of points the last one lies past the end.
constexpr int coarser(int points) {
    return points / 2 + 1;
}

} // namespace dipwright::numerics::galerkin

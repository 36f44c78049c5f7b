// The constants and formulas of the multigrid cycle for the film's stiffness, for all devices.
//
// The finest grid's operator is assembled from the current stiffness of every triangle
// (EdgeStiffness.h). This includes stretched, gathered, rotated and crossing triangles, and
// triangles beside held film. A coarser grid keeps every second point. With bilinear interpolation
// P between two grids, the coarse operator is PᵀKP (Galerkin). So the coarse grids represent where
// film is soft and where it is held; a constant stencil of the flat film would not. Smoothing uses
// Chebyshev polynomials over the points' own 2 × 2 blocks. The result does not depend on the number
// of threads.
#pragma once

#include <array>

namespace dipwright::numerics::galerkin {

// Smoothing covers the part of the spectrum of block⁻¹·stiffness between these two values.
inline constexpr double largestEigenvalue = 2.4;
inline constexpr double smallestSmoothed = 0.4;
inline constexpr int smoothingDegree = 2;
inline constexpr int coarsestDegree = 16;
// A point's own block is treated as singular below this ratio of its determinant to its squared
// trace.
inline constexpr float leastDeterminant = 1e-4f;
inline constexpr int coarsestPoints = 5; // at most, along the shorter edge of the coarsest grid

// One step of the polynomial: direction ← keep·direction + gain·block⁻¹·residual. The direction is
// then added to the result.
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
// Returns the number of coarse points. Coarse point c lies on fine point 2c. If the number of fine
// points is even, the last coarse point lies past the end.
constexpr int coarser(int points) {
    return points / 2 + 1;
}

} // namespace dipwright::numerics::galerkin

// What a multigrid cycle for the flat film's linear elasticity consists of, whatever computes it.
//
// The operator is that of the undeformed isotropic film, averaged over both ways to cut a cell: one
// constant 9-point stencil on every level. Grids of any size are coarsened to half as many points,
// with bilinear interpolation and its transpose; smoothing is by Chebyshev polynomials, so that the
// cycle is symmetric and positive definite, as conjugate gradients need.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace dipwright::numerics::multigrid {

// Smoothing takes care of the part of the spectrum (of diagonal⁻¹·stiffness) between these.
inline constexpr double largestEigenvalue = 2.15;
inline constexpr double smallestSmoothed = 0.22;
inline constexpr int smoothingDegree = 3;
inline constexpr int coarsestDegree = 24;
inline constexpr int coarsestPoints = 6; // along the shorter edge: no coarser

// One step of the polynomial: direction ← keep·direction + gain·diagonal⁻¹·residual, added to the
// result.
struct ChebyshevStep {
    float keep = 0, gain = 0;
};

inline std::vector<ChebyshevStep> chebyshev(int degree) {
    const double centre = (largestEigenvalue + smallestSmoothed) / 2;
    const double radius = (largestEigenvalue - smallestSmoothed) / 2;
    std::vector<ChebyshevStep> steps{{0, float(1 / centre)}};
    double rho = radius / centre;
    while (int(steps.size()) < degree) {
        const double next = 1 / (2 * centre / radius - rho);
        steps.push_back({float(next * rho), float(2 * next / radius)});
        rho = next;
    }
    return steps;
}

// The stiffness of one cell at rest (PlaneStress.h), with both ways to cut it taken by half: nodes
// (0,0), (1,0), (0,1), (1,1), x and z of each.
using CellStiffness = std::array<std::array<float, 8>, 8>;

inline CellStiffness cellStiffness(double hx, double hz) {
    std::array<std::array<double, 8>, 8> sum{};
    for (std::size_t horizontal = 0; horizontal < 2; ++horizontal) {
        for (std::size_t vertical = 0; vertical < 2; ++vertical) {
            std::array<double, 8> a{}, b{}, c{}, d{}; // F − 1 from the nodes
            const std::size_t h0 = 2 * horizontal, h1 = h0 + 1, v0 = vertical, v1 = vertical + 2;
            a[2 * h1] += 1 / hx, a[2 * h0] -= 1 / hx;
            c[2 * h1 + 1] += 1 / hx, c[2 * h0 + 1] -= 1 / hx;
            b[2 * v1] += 1 / hz, b[2 * v0] -= 1 / hz;
            d[2 * v1 + 1] += 1 / hz, d[2 * v0 + 1] -= 1 / hz;
            for (std::size_t m = 0; m < 8; ++m) {
                for (std::size_t n = 0; n < 8; ++n) {
                    sum[m][n] += hx * hz / 4 *
                                 (3 * a[m] * a[n] + 3 * d[m] * d[n] + a[m] * d[n] + d[m] * a[n] +
                                  (b[m] + c[m]) * (b[n] + c[n]));
                }
            }
        }
    }
    CellStiffness result{};
    for (std::size_t m = 0; m < 8; ++m) {
        for (std::size_t n = 0; n < 8; ++n) {
            result[m][n] = float(sum[m][n]);
        }
    }
    return result;
}

// The weights of the 9-point stencil inside the film: of neighbours along X and Z, for the x and
// for the z component.
struct Stencil {
    float xx = 0, xz = 0, zx = 0, zz = 0;
};

inline Stencil stencil(double hx, double hz) {
    return {float(3 * hz / hx), float(hx / hz), float(hz / hx), float(3 * hx / hz)};
}

inline bool isCoarsest(int columns, int rows) {
    return std::min(columns, rows) <= coarsestPoints;
}
inline int coarser(int points) {
    return (points + 1) / 2;
}

// Interpolation along one axis: fine point i from coarse points first[i] and first[i] + 1, the
// latter with weight[i].
struct Interpolation {
    std::vector<int> first;
    std::vector<float> weight;
};

inline Interpolation interpolation(int fine, int coarse) {
    Interpolation axis;
    for (int i = 0; i < fine; ++i) {
        const double place = double(i) * (coarse - 1) / (fine - 1);
        const int first = std::min(int(place), coarse - 2);
        axis.first.push_back(first);
        axis.weight.push_back(float(place - first));
    }
    return axis;
}

} // namespace dipwright::numerics::multigrid

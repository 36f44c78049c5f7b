// Trilinear sampling of the signed distance field (docs/film-model.md, "Frames").
#pragma once

#include "common/Vector3.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::numerics {

// A FieldView in the solver's precision. Does not own `distance`, which may lie on a device.
template <typename Real>
struct FieldGrid {
    const float* distance = nullptr;
    int nx = 0, ny = 0, nz = 0;
    // The place of sample (0, 0, 0), in body coordinates.
    Vector3<Real> origin;
    Real spacing{};
    Real inverseSpacing{};
};

template <typename Real>
FieldGrid<Real> fieldGrid(const solver::FieldView& view) {
    return {view.distance,
            view.size[0],
            view.size[1],
            view.size[2],
            {Real(view.origin[0]), Real(view.origin[1]), Real(view.origin[2])},
            Real(view.spacing),
            Real(1 / view.spacing)};
}

template <typename Real>
struct FieldSample {
    Real distance{};        // φ, mm, negative inside
    Vector3<Real> gradient; // ∇φ of the trilinear interpolant, not normalised
    Real outside{};         // distance to the grid in mm, 0 inside it
};

namespace detail {

// One coordinate in units of cells, clamped to the grid: the index of the cell, the position within
// that cell, and the distance to the grid.
template <typename Real>
struct CellPlace {
    int cell;
    Real fraction, outside;
};

template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP CellPlace<Real> cellPlace(Real coordinate, int size) {
    const Real last = Real(size - 1);
    const Real clamped = coordinate > Real(0) ? (coordinate < last ? coordinate : last) : Real(0);
    int cell = int(clamped);
    cell = cell > size - 2 ? size - 2 : cell;
    return {cell, clamped - Real(cell), coordinate - clamped};
}

// Returns a number in global memory that does not change while a kernel runs. A GPU then loads it
// faster.
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP float constant(const float& number) {
#if defined(__CUDA_ARCH__)
    return __ldg(&number);
#else
    return number;
#endif
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE Real mix(Real a, Real b, Real t) {
    return a + t * (b - a);
}

} // namespace detail

// Samples φ and ∇φ at `position` (body coordinates). Outside the grid, the result is the sample at
// the nearest point of the grid plus the distance to that point. A NaN position gives a NaN
// distance.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP FieldSample<Real> sampleField(const FieldGrid<Real>& field,
                                                                      Vector3<Real> position) {
    using detail::constant, detail::mix;
    const Vector3<Real> grid = (position - field.origin) * field.inverseSpacing;
    const auto x = detail::cellPlace(grid.x, field.nx);
    const auto y = detail::cellPlace(grid.y, field.ny);
    const auto z = detail::cellPlace(grid.z, field.nz);

    const std::size_t rowStride = std::size_t(field.nx);
    const std::size_t layerStride = rowStride * std::size_t(field.ny);
    const float* corner = field.distance + std::size_t(z.cell) * layerStride +
                          std::size_t(y.cell) * rowStride + std::size_t(x.cell);
    const Real c000 = constant(corner[0]), c100 = constant(corner[1]);
    const Real c010 = constant(corner[rowStride]), c110 = constant(corner[rowStride + 1]);
    const Real c001 = constant(corner[layerStride]), c101 = constant(corner[layerStride + 1]);
    const Real c011 = constant(corner[layerStride + rowStride]),
               c111 = constant(corner[layerStride + rowStride + 1]);

    const Real c00 = mix(c000, c100, x.fraction), c10 = mix(c010, c110, x.fraction);
    const Real c01 = mix(c001, c101, x.fraction), c11 = mix(c011, c111, x.fraction);
    const Real c0 = mix(c00, c10, y.fraction), c1 = mix(c01, c11, y.fraction);

    const Real alongX0 = mix(c100 - c000, c110 - c010, y.fraction);
    const Real alongX1 = mix(c101 - c001, c111 - c011, y.fraction);
    const Vector3<Real> gradient{mix(alongX0, alongX1, z.fraction),
                                 mix(c10 - c00, c11 - c01, z.fraction), c1 - c0};
    const Vector3<Real> beyond{x.outside, y.outside, z.outside};
    const Real squared = dot(beyond, beyond); // nearly always 0, so the root is skipped
    const Real outside = squared == Real(0) ? Real(0) : std::sqrt(squared) * field.spacing;
    return {mix(c0, c1, z.fraction) + outside, gradient * field.inverseSpacing, outside};
}

// Returns the derivative of φ along an axis (0 is X) at `position`, from the central difference
// over one cell on each side.
template <typename Real>
DIPWRIGHT_HOST_DEVICE Real smoothSlope(const FieldGrid<Real>& field, Vector3<Real> position,
                                       int axis) {
    const Vector3<Real> way{axis == 0 ? field.spacing : Real(0),
                            axis == 1 ? field.spacing : Real(0),
                            axis == 2 ? field.spacing : Real(0)};
    return (sampleField(field, position + way).distance -
            sampleField(field, position - way).distance) *
           (Real(0.5) * field.inverseSpacing);
}

// Returns ∇φ at `position` from central differences. The result changes continuously from cell to
// cell; the gradient of the trilinear interpolant does not.
template <typename Real>
DIPWRIGHT_HOST_DEVICE Vector3<Real> smoothGradient(const FieldGrid<Real>& field,
                                                   Vector3<Real> position) {
    return {smoothSlope(field, position, 0), smoothSlope(field, position, 1),
            smoothSlope(field, position, 2)};
}

// Returns a lower bound of the distance to the body; interpolation may make it slightly too large.
// The body must lie inside the field's grid.
template <typename Real>
DIPWRIGHT_HOST_DEVICE Real clearance(const FieldSample<Real>& sample) {
    const Real nearGrid = sample.distance - sample.outside - sample.outside;
    return nearGrid > sample.outside || sample.outside == Real(0) ? nearGrid : sample.outside;
}

// Moves `position` along ∇φ to the level set φ = `level` by Newton's method. A few steps are
// enough, as φ is nearly linear over a cell. Stops where the gradient vanishes. `sample` is the
// sample at `position`.
template <typename Real>
DIPWRIGHT_HOST_DEVICE Vector3<Real> onLevel(const FieldGrid<Real>& field, Vector3<Real> position,
                                            FieldSample<Real> sample, Real level) {
    const int steps = 8;
    const Real closeEnough = Real(1e-4) * field.spacing;
    const Real flattest =
        Real(0.25); // |∇φ|² is 1 except near ridges, where a step would be unreliable
    for (int step = 0; step < steps; ++step) {
        const Real missing = level - sample.distance;
        if (std::abs(missing) <= closeEnough) {
            break;
        }
        const Real steepness = dot(sample.gradient, sample.gradient);
        position =
            position + sample.gradient * (missing / (steepness > flattest ? steepness : flattest));
        sample = sampleField(field, position);
    }
    return position;
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE Vector3<Real> onLevel(const FieldGrid<Real>& field, Vector3<Real> position,
                                            Real level) {
    return onLevel(field, position, sampleField(field, position), level);
}

} // namespace dipwright::numerics

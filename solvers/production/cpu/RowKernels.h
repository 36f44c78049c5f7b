// The row loops that take most of the CPU time of the production film. They are compiled for each
// instruction set that Highway supports, and the best one is chosen at run time. All instruction
// sets give the same bits as the GPU: no fused multiply-add, and the same order of operations.
#pragma once

#include "production/formulas/GridTriangle.h"
#include "production/formulas/OrderlessSum.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace dipwright::cpu {

// The x and z values of a row of points or cells.
struct RowOfPairs {
    const float *x, *z;
};

// Returns factor·Σ (a.x·b.x + a.z·b.z), in multiples (OrderlessSum.h). In these three sums, each
// pair is summed in single precision before it is rounded to multiples.
std::int64_t rowProducts(const RowOfPairs& a, const RowOfPairs& b, float factor, std::size_t count);
// Return Σ (x² + z²) and Σ weight·(x² + z²).
numerics::SquareSum rowSquares(const RowOfPairs& a, std::size_t count);
numerics::SquareSum rowWeightedSquares(const float* weight, const RowOfPairs& a, std::size_t count);

// Returns the largest absolute value; ignores NaN.
float rowLargest(const float* a, std::size_t count);

// Computes out += factor·a.
void addScaled(std::size_t count, float factor, const float* a, float* out);
// Computes out = factor·a.
void scaledRow(std::size_t count, float factor, const float* a, float* out);
// Computes out += factor·weight·a.
void addWeighted(std::size_t count, float factor, const float* weight, const float* a, float* out);
// Computes out += factor·weight·(a − b).
void addDifference(std::size_t count, float factor, const float* weight, const float* a,
                   const float* b, float* out);
// Computes out *= a.
void multiplyBy(std::size_t count, const float* a, float* out);

// Holds several kinds of numbers for each point, cell or triangle of a row. Each kind has its own
// line.
template <typename Number>
struct Lines {
    Number* first = nullptr;
    std::size_t pitch = 0; // distance from line to line, in numbers
    Number* operator[](std::size_t line) const { return first + line * pitch; }
};

// The coordinates of the points around a row of cells: x0, z0 in the lower row of points, x1, z1 in
// the upper row.
struct RowOfPoints {
    const float *x0, *z0, *x1, *z1;
};
// The forces on the edges of a row of cells: on the lower (first) and upper (second) horizontal
// edges, and each cell's contribution to its left and right vertical edges.
struct RowOfForces {
    float *firstX, *firstZ, *secondX, *secondZ, *leftX, *leftZ, *rightX, *rightZ;
};
// The lengths of the undeformed edges of a row of cells, and their inverses: one value per column
// along X, one for all columns along Z.
struct RowOfSizes {
    const float *edgesX, *inversesX;
    float edgeZ = 0, inverseZ = 0;
};
// The rest state of a row of cells: the inverse rest shapes of the first and second triangles. They
// are used only if `isCrept`; otherwise all rest shapes are undeformed.
struct RowOfShapes {
    struct Pointers {
        const float *a, *b, *c, *d;
    };
    bool isCrept = false;
    std::array<Pointers, 2> shapes{};
    RowOfSizes sizes;
};
template <typename Pointer>
struct RowOfStates { // states of the first and second triangles (StressState)
    struct Pointers {
        Pointer cosine, sine, turn, resists;
    };
    std::array<Pointers, 2> states{};
};

// Returns the edges of the first or `second` triangle of cell `i`. `right`: whether the triangle
// has the cell's right edge instead of its left edge. If `p` are displacements, `restX` and `restZ`
// are the lengths of the rest edges; if `p` is a direction, they are 0.
DIPWRIGHT_IN_LOOP numerics::EdgePair<float>
cellEdges(const RowOfPoints& p, std::size_t i, bool second, bool right, float restX, float restZ) {
    const float* hx = second ? p.x1 : p.x0;
    const float* hz = second ? p.z1 : p.z0;
    const float leftEdgeX = p.x1[i] - p.x0[i], rightEdgeX = p.x1[i + 1] - p.x0[i + 1];
    const float leftEdgeZ = p.z1[i] - p.z0[i], rightEdgeZ = p.z1[i + 1] - p.z0[i + 1];
    return {restX + (hx[i + 1] - hx[i]), hz[i + 1] - hz[i], right ? rightEdgeX : leftEdgeX,
            restZ + (right ? rightEdgeZ : leftEdgeZ)};
}

// Computes the gradient of the elastic energy at displaced points, and the states for the Hessian.
// `parity` is 0 for an even row of cells and 1 for an odd row. In an even cell, the first triangle
// has the right vertical edge.
void gradientRow(std::size_t cells, unsigned parity, const RowOfPoints& points,
                 const RowOfShapes& shapes, float gatheredResistance,
                 const RowOfStates<float*>& states, const RowOfForces& forces);
// Multiplies the Hessian by a direction at the points.
void hessianRow(std::size_t cells, unsigned parity, const RowOfPoints& direction,
                const RowOfShapes& shapes, const RowOfStates<const float*>& states,
                numerics::Tangent tangent, const RowOfForces& forces);
// Computes the stiffness of the first and second triangles in a row of cells, 16 lines each
// (EdgeStiffness.h: hh, hv, vh, vv).
void stiffnessRow(std::size_t cells, const RowOfShapes& shapes,
                  const RowOfStates<const float*>& states, const Lines<float>& first,
                  const Lines<float>& second);
// Computes the inverse rest shapes of the first or second triangles in a row of cells after they
// have relaxed (relaxedInverseShape()): the four lines a, b, c and d. `parity` and `points` are as
// in gradientRow().
void relaxRow(std::size_t cells, unsigned parity, bool second, const RowOfPoints& points,
              const RowOfShapes& shapes, float keep, const Lines<float>& relaxed);
// The range of stretch of the moving triangles in a row of cells, relative to the undeformed film:
// the largest λ1² + λ2² and the smallest λ1 λ2.
struct StretchRange {
    float largestSquares = 0, leastArea = 0;
};
StretchRange stretchRange(std::size_t cells, unsigned parity, const RowOfPoints& points,
                          const std::array<const float*, 2>& moving, const RowOfSizes& sizes);
// Adds the forces of a row of cells to a row of points. For the lower row of points, `sign` is −1
// and `edge` the first horizontal edges. For the upper row, `sign` is +1 and `edge` the second
// horizontal edges.
void addForces(std::size_t cells, float sign, const float* edge, const float* left,
               const float* right, float* out);

} // namespace dipwright::cpu

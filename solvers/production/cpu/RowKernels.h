// The loops over rows that the production film on the CPU spends its time in, each compiled for
// every instruction set that Highway knows for the processor and chosen at run time. The same bits
// on all of them: no fused multiply-add, and sums always in the same order.
#pragma once

#include "production/formulas/GridTriangle.h"

#include <array>
#include <cstddef>

namespace dipwright::cpu {

// Σ a·b and Σ weight·a²: sixteen running sums.
double rowDot(const float* a, const float* b, std::size_t count);
double rowWeightedSquares(const float* weight, const float* a, std::size_t count);

void addScaled(std::size_t count, float factor, const float* a, float* out); // out += factor·a
void scaleRow(std::size_t count, float factor, float* out);                  // out *= factor
// out += factor·weight·a, and out += factor·weight·(a − b)
void addWeighted(std::size_t count, float factor, const float* weight, const float* a, float* out);
void addDifference(std::size_t count, float factor, const float* weight, const float* a,
                   const float* b, float* out);
void multiplyBy(std::size_t count, const float* a, float* out); // out *= a

// Several numbers for each point, cell or triangle of a row, each of them in a line of its own.
template <typename Number>
struct Lines {
    Number* first = nullptr;
    std::size_t pitch = 0; // numbers from line to line
    Number* operator[](std::size_t line) const { return first + line * pitch; }
};

// A row of cells: x0, z0 the lower row of points, x1, z1 the upper one.
struct RowOfPoints {
    const float *x0, *z0, *x1, *z1;
};
// Forces on the edges of a row of cells: of the lower (first) and upper horizontal edges, and what
// each cell adds to its left and right vertical edge.
struct RowOfForces {
    float *firstX, *firstZ, *secondX, *secondZ, *leftX, *leftZ, *rightX, *rightZ;
};
// The undeformed film in a row of cells: of each column of them the length of an edge along X and
// its inverse, and both of the edges along Z.
struct RowOfSizes {
    const float *edgesX, *inversesX;
    float edgeZ = 0, inverseZ = 0;
};
// The film in a row of cells at rest: the inverse rest shapes of first and second triangles, unless
// all are as undeformed.
struct RowOfShapes {
    struct Pointers {
        const float *a, *b, *c, *d;
    };
    bool isCrept = false;
    std::array<Pointers, 2> shapes{};
    RowOfSizes sizes;
};
template <typename Pointer>
struct RowOfStates { // StressState of first and second triangles
    struct Pointers {
        Pointer cosine, sine, turn, resists;
    };
    std::array<Pointers, 2> states{};
};

// The edges of one triangle of cell `i`; `right`: its vertical edge is the cell's right one. restX,
// restZ: the edges at rest for displacements, zero for directions.
inline numerics::EdgePair<float> cellEdges(const RowOfPoints& p, std::size_t i, bool second,
                                           bool right, float restX, float restZ) {
    const float* hx = second ? p.x1 : p.x0;
    const float* hz = second ? p.z1 : p.z0;
    const float leftEdgeX = p.x1[i] - p.x0[i], rightEdgeX = p.x1[i + 1] - p.x0[i + 1];
    const float leftEdgeZ = p.z1[i] - p.z0[i], rightEdgeZ = p.z1[i + 1] - p.z0[i + 1];
    return {restX + (hx[i + 1] - hx[i]), hz[i + 1] - hz[i], right ? rightEdgeX : leftEdgeX,
            restZ + (right ? rightEdgeZ : leftEdgeZ)};
}

// The gradient of the elastic energy at displaced points, and the states at which the Hessian is
// taken. `parity` of the row: in an even cell the first triangle takes the right vertical edge.
void gradientRow(std::size_t cells, unsigned parity, const RowOfPoints& points,
                 const RowOfShapes& shapes, float gatheredResistance,
                 const RowOfStates<float*>& states, const RowOfForces& forces);
// The Hessian times a direction at the points.
void hessianRow(std::size_t cells, unsigned parity, const RowOfPoints& direction,
                const RowOfShapes& shapes, const RowOfStates<const float*>& states,
                numerics::Tangent tangent, const RowOfForces& forces);
// The stiffness of first and of second triangles: 16 lines each (EdgeStiffness.h: hh, hv, vh, vv).
void stiffnessRow(std::size_t cells, const RowOfShapes& shapes,
                  const RowOfStates<const float*>& states, const Lines<float>& first,
                  const Lines<float>& second);
// Of the moving triangles of a row of cells, against the undeformed film: the largest λ1² + λ2²,
// and the least λ1 λ2.
struct StretchRange {
    float largestSquares = 0, leastArea = 0;
};
StretchRange stretchRange(std::size_t cells, unsigned parity, const RowOfPoints& points,
                          const std::array<const float*, 2>& moving, const RowOfSizes& sizes);
// Adds the forces of a row of cells to a row of points: to the lower row (`sign` −1, `edge` the
// first horizontal edges) or to the upper row (`sign` +1, the second ones).
void addForces(std::size_t cells, float sign, const float* edge, const float* left,
               const float* right, float* out);

} // namespace dipwright::cpu

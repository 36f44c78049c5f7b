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
void scaleAndAdd(std::size_t count, float factor, const float* a,
                 float* out); // out = factor·out + a
// out += factor·(a − b)
void addDifference(std::size_t count, float factor, const float* a, const float* b, float* out);
void subtract(std::size_t count, const float* a, const float* b, float* out); // out = a − b
void multiplyBy(std::size_t count, const float* a, float* out);               // out *= a

// Multigrid: one row of the nine-point stencil, but for its first and last point. `along` weighs
// the neighbours in X, `across` those in Z; the other component enters by the four corners (the
// mixed derivative).
struct StencilRow {
    const float *below, *here, *above;
};
void stencilRow(std::size_t columns, const StencilRow& own, const StencilRow& other, float along,
                float across, const float* free, float* out);
// One step of Chebyshev smoothing.
void chebyshevRow(std::size_t count, float keep, float gain, const float* diagonal,
                  const float* residual, float* direction, float* result);

// A row of cells: x0, z0 the lower row of points, x1, z1 the upper one.
struct RowOfPoints {
    const float *x0, *z0, *x1, *z1;
};
// Forces on the edges of a row of cells: of the lower (first) and upper horizontal edges, and what
// each cell adds to its left and right vertical edge.
struct RowOfForces {
    float *firstX, *firstZ, *secondX, *secondZ, *leftX, *leftZ, *rightX, *rightZ;
};
// The film in a row of cells at rest: the inverse rest shapes of first and second triangles, or,
// where all are the undeformed one, `common`.
struct RowOfShapes {
    struct Pointers {
        const float *a, *b, *c, *d;
    };
    bool isCrept = false;
    std::array<Pointers, 2> shapes{};
    numerics::Matrix2<float> common;
    float area = 0; // of a triangle
};
template <typename Pointer>
struct RowOfStates { // StressState of first and second triangles
    struct Pointers {
        Pointer cosine, sine, turn;
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
                 const RowOfShapes& shapes, float restX, float restZ,
                 const RowOfStates<float*>& states, const RowOfForces& forces);
// The Hessian times a direction at the points.
void hessianRow(std::size_t cells, unsigned parity, const RowOfPoints& direction,
                const RowOfShapes& shapes, const RowOfStates<const float*>& states,
                const RowOfForces& forces);
// The largest λ1² + λ2², against the undeformed film, of the moving triangles of a row of cells.
float largestSquare(std::size_t cells, unsigned parity, const RowOfPoints& points,
                    const std::array<const float*, 2>& moving, float inverseX, float inverseZ);
// Adds the forces of a row of cells to a row of points: to the lower row (`sign` −1, `edge` the
// first horizontal edges) or to the upper row (`sign` +1, the second ones).
void addForces(std::size_t cells, float sign, const float* edge, const float* left,
               const float* right, float* out);

} // namespace dipwright::cpu

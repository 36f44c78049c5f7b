#include "production/cpu/PlaneFilm.h"

#include "common/cpu/RowParallel.h"
#include "common/cpu/SimdClones.h"
#include "production/cpu/RowMath.h"
#include "production/formulas/PlaneStress.h"

namespace dipwright::cpu {

using numerics::edgeForces;
using numerics::gradientOf;
using numerics::Matrix2;
using numerics::StressState;

namespace {

// Forces on the edges of one row of cells: of the lower (first) and upper horizontal edges, and
// what each cell adds to its left and right vertical edge.
struct EdgeForces {
    explicit EdgeForces(std::size_t count) : storage(8 * count), cells(count) {}
    float* array(int which) { return storage.data() + std::size_t(which) * cells; }
    std::vector<float> storage;
    std::size_t cells;
};
enum { firstX, firstZ, secondX, secondZ, leftX, leftZ, rightX, rightZ };

struct ShapePointers {
    const float *a, *b, *c, *d;
};
struct MutableStatePointers {
    float *cosine, *sine, *turn;
};
struct StatePointers {
    const float *cosine, *sine, *turn;
};

// The edges of one triangle of a cell: the first triangle takes the lower horizontal edge, and the
// right vertical edge in an even cell, the left one in an odd cell.
using CellEdges = numerics::EdgePair<float>;

template <bool crept>
inline Matrix2<float> shapeAt(const ShapePointers& shape, const Matrix2<float>& common,
                              std::size_t i) {
    if constexpr (crept) {
        return {shape.a[i], shape.b[i], shape.c[i], shape.d[i]};
    } else {
        return common;
    }
}

// x0, z0: the lower row of points; x1, z1: the upper one. `rest` is added to the horizontal and
// vertical edges: the resting edge for displacements, zero for directions.
struct RowOfPoints {
    const float *x0, *z0, *x1, *z1;
};

struct RowOfForces {
    float *firstX, *firstZ, *secondX, *secondZ, *leftX, *leftZ, *rightX, *rightZ;
};

RowOfForces rowOfForces(EdgeForces& forces) {
    return {forces.array(firstX),  forces.array(firstZ), forces.array(secondX),
            forces.array(secondZ), forces.array(leftX),  forces.array(leftZ),
            forces.array(rightX),  forces.array(rightZ)};
}

inline CellEdges cellEdges(const RowOfPoints& p, std::size_t i, bool second, bool right,
                           float restX, float restZ) {
    const float* hx = second ? p.x1 : p.x0;
    const float* hz = second ? p.z1 : p.z0;
    const float leftEdgeX = p.x1[i] - p.x0[i], rightEdgeX = p.x1[i + 1] - p.x0[i + 1];
    const float leftEdgeZ = p.z1[i] - p.z0[i], rightEdgeZ = p.z1[i + 1] - p.z0[i + 1];
    return {restX + (hx[i + 1] - hx[i]), hz[i + 1] - hz[i], right ? rightEdgeX : leftEdgeX,
            restZ + (right ? rightEdgeZ : leftEdgeZ)};
}

template <bool crept>
DIPWRIGHT_ALWAYS_INLINE void
gradientCells(std::size_t cells, unsigned parity, const RowOfPoints& p,
              const ShapePointers (&shapes)[2], Matrix2<float> common, float restX, float restZ,
              float area, const MutableStatePointers (&states)[2], const RowOfForces& out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < cells; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        StressState<float> state0, state1;
        const Matrix2<float> shape0 = shapeAt<crept>(shapes[0], common, i);
        const Matrix2<float> shape1 = shapeAt<crept>(shapes[1], common, i);
        const CellEdges force0 = edgeForces(
            stress(gradientOf(cellEdges(p, i, false, even, restX, restZ), shape0), state0), shape0,
            area);
        const CellEdges force1 = edgeForces(
            stress(gradientOf(cellEdges(p, i, true, !even, restX, restZ), shape1), state1), shape1,
            area);
        states[0].cosine[i] = state0.cosine;
        states[0].sine[i] = state0.sine;
        states[0].turn[i] = state0.turn;
        states[1].cosine[i] = state1.cosine;
        states[1].sine[i] = state1.sine;
        states[1].turn[i] = state1.turn;
        out.firstX[i] = force0.hx;
        out.firstZ[i] = force0.hz;
        out.secondX[i] = force1.hx;
        out.secondZ[i] = force1.hz;
        out.leftX[i] = even ? force1.vx : force0.vx;
        out.leftZ[i] = even ? force1.vz : force0.vz;
        out.rightX[i] = even ? force0.vx : force1.vx;
        out.rightZ[i] = even ? force0.vz : force1.vz;
    }
}

template <bool crept>
DIPWRIGHT_ALWAYS_INLINE void hessianCells(std::size_t cells, unsigned parity, const RowOfPoints& p,
                                          const ShapePointers (&shapes)[2], Matrix2<float> common,
                                          float area, const StatePointers (&states)[2],
                                          const RowOfForces& out) {
    DIPWRIGHT_INDEPENDENT_LOOP
    for (std::size_t i = 0; i < cells; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        const Matrix2<float> shape0 = shapeAt<crept>(shapes[0], common, i);
        const Matrix2<float> shape1 = shapeAt<crept>(shapes[1], common, i);
        const StressState<float> state0{states[0].cosine[i], states[0].sine[i], states[0].turn[i]};
        const StressState<float> state1{states[1].cosine[i], states[1].sine[i], states[1].turn[i]};
        const CellEdges force0 = edgeForces(
            stressDerivative(gradientOf(cellEdges(p, i, false, even, 0, 0), shape0), state0),
            shape0, area);
        const CellEdges force1 = edgeForces(
            stressDerivative(gradientOf(cellEdges(p, i, true, !even, 0, 0), shape1), state1),
            shape1, area);
        out.firstX[i] = force0.hx;
        out.firstZ[i] = force0.hz;
        out.secondX[i] = force1.hx;
        out.secondZ[i] = force1.hz;
        out.leftX[i] = even ? force1.vx : force0.vx;
        out.leftZ[i] = even ? force1.vz : force0.vz;
        out.rightX[i] = even ? force0.vx : force1.vx;
        out.rightZ[i] = even ? force0.vz : force1.vz;
    }
}

DIPWRIGHT_SIMD_CLONES
void gradientRow(bool crept, std::size_t cells, unsigned parity, const RowOfPoints& p,
                 const ShapePointers (&shapes)[2], Matrix2<float> common, float restX, float restZ,
                 float area, const MutableStatePointers (&states)[2], const RowOfForces& out) {
    if (crept) {
        gradientCells<true>(cells, parity, p, shapes, common, restX, restZ, area, states, out);
    } else {
        gradientCells<false>(cells, parity, p, shapes, common, restX, restZ, area, states, out);
    }
}

DIPWRIGHT_SIMD_CLONES
void hessianRow(bool crept, std::size_t cells, unsigned parity, const RowOfPoints& p,
                const ShapePointers (&shapes)[2], Matrix2<float> common, float area,
                const StatePointers (&states)[2], const RowOfForces& out) {
    if (crept) {
        hessianCells<true>(cells, parity, p, shapes, common, area, states, out);
    } else {
        hessianCells<false>(cells, parity, p, shapes, common, area, states, out);
    }
}

// The largest λ1² + λ2², against the undeformed film, of the moving triangles of one row of cells.
DIPWRIGHT_SIMD_CLONES
float largestSquare(std::size_t cells, unsigned parity, const RowOfPoints& p,
                    const std::array<const float*, 2>& moving, float inverseX, float inverseZ) {
    float largest = 0;
    for (std::size_t i = 0; i < cells; ++i) {
        const bool even = ((unsigned(i) + parity) & 1u) == 0;
        const auto square = [&](bool second) {
            const CellEdges e = cellEdges(p, i, second, even != second, 1 / inverseX, 1 / inverseZ);
            return (e.hx * e.hx + e.hz * e.hz) * inverseX * inverseX +
                   (e.vx * e.vx + e.vz * e.vz) * inverseZ * inverseZ;
        };
        const float first = moving[0][i] * square(false), second = moving[1][i] * square(true);
        largest = largest > first ? largest : first;
        largest = largest > second ? largest : second;
    }
    return largest;
}

// Adds the forces of one row of cells to a row of points: to the lower row (`sign` −1, `edge` the
// first horizontal edges) or to the upper row (`sign` +1, the second ones).
DIPWRIGHT_SIMD_CLONES
void addForces(std::size_t cells, float sign, const float* edge, const float* left,
               const float* right, float* out) {
    out[0] += -edge[0] + sign * left[0];
    for (std::size_t i = 1; i < cells; ++i) {
        out[i] += (edge[i - 1] - edge[i]) + sign * (left[i] + right[i - 1]);
    }
    out[cells] += edge[cells - 1] + sign * right[cells - 1];
}

// Runs cellRow(j, forces) for every row of cells and gathers the forces on the points of `result`.
template <typename CellRow>
void gatherForces(int columns, int rows, PlaneVector& result, const CellRow& cellRow) {
    const std::size_t width = std::size_t(columns), cells = width - 1;
    forRowBands(rows, columns, [&](int begin, int end) {
        EdgeForces forces(cells);
        std::fill(result.x.begin() + begin * columns, result.x.begin() + end * columns, 0.f);
        std::fill(result.z.begin() + begin * columns, result.z.begin() + end * columns, 0.f);
        for (int j = std::max(begin - 1, 0); j < std::min(end, rows - 1); ++j) {
            cellRow(j, j >= begin, forces);
            if (j >= begin) {
                float* x = result.x.data() + std::size_t(j) * width;
                float* z = result.z.data() + std::size_t(j) * width;
                addForces(cells, -1, forces.array(firstX), forces.array(leftX),
                          forces.array(rightX), x);
                addForces(cells, -1, forces.array(firstZ), forces.array(leftZ),
                          forces.array(rightZ), z);
            }
            if (j + 1 < end) {
                float* x = result.x.data() + std::size_t(j + 1) * width;
                float* z = result.z.data() + std::size_t(j + 1) * width;
                addForces(cells, 1, forces.array(secondX), forces.array(leftX),
                          forces.array(rightX), x);
                addForces(cells, 1, forces.array(secondZ), forces.array(leftZ),
                          forces.array(rightZ), z);
            }
        }
    });
}

void putForces(EdgeForces& forces, std::size_t cell, const PlaneFilm::Crossing& triangle,
               const numerics::EdgePair<float>& force) {
    forces.array(triangle.second ? secondX : firstX)[cell] = force.hx;
    forces.array(triangle.second ? secondZ : firstZ)[cell] = force.hz;
    forces.array(triangle.thirdOnRight ? rightX : leftX)[cell] = force.vx;
    forces.array(triangle.thirdOnRight ? rightZ : leftZ)[cell] = force.vz;
}

RowOfPoints rowOfPoints(const PlaneVector& v, std::size_t width, int j) {
    const std::size_t first = std::size_t(j) * width, second = first + width;
    return {v.x.data() + first, v.z.data() + first, v.x.data() + second, v.z.data() + second};
}

} // namespace

PlaneFilm::PlaneFilm(const solver::FilmGrid& grid)
    : columns_(grid.columns), rows_(grid.rows), inverseX_(float(1 / grid.spacingX())),
      inverseZ_(float(1 / grid.spacingZ())), area_(float(grid.spacingX() * grid.spacingZ() / 2)) {
    const std::size_t cells = std::size_t(columns_ - 1) * std::size_t(rows_ - 1);
    for (States& state : state_) {
        state.cosine.assign(cells, 1.f);
        state.sine.assign(cells, 0.f);
        state.turn.assign(cells, -1.f);
    }
    moving_[0] = moving_[1] = std::vector<float>(cells, 1.f);
    crept_.assign(std::size_t(rows_ - 1), 0);
    for (TriangleArrays& shape : inverseShape_) {
        shape.a.assign(cells, inverseX_);
        shape.b.assign(cells, 0.f);
        shape.c.assign(cells, 0.f);
        shape.d.assign(cells, inverseZ_);
    }
}

Matrix2<float> PlaneFilm::inverseShape(std::size_t cell, bool second) const {
    const TriangleArrays& shape = inverseShape_[second];
    return {shape.a[cell], shape.b[cell], shape.c[cell], shape.d[cell]};
}

void PlaneFilm::setInverseShape(std::size_t cell, bool second, const Matrix2<float>& shape) {
    TriangleArrays& arrays = inverseShape_[second];
    arrays.a[cell] = shape.a;
    arrays.b[cell] = shape.b;
    arrays.c[cell] = shape.c;
    arrays.d[cell] = shape.d;
}

Matrix2<float> PlaneFilm::wholeGradient(const Crossing& triangle,
                                        const PlaneVector& displacement) const {
    return gradientOf(unfoldedEdges(edges(numberOf(triangle), displacement), triangle),
                      inverseShape(triangle.cell, triangle.second));
}

void PlaneFilm::setFree(const std::vector<float>& free) {
    const std::size_t width = std::size_t(columns_), cells = width - 1;
    for (std::size_t j = 0; j + 1 < std::size_t(rows_); ++j) {
        const float* lower = free.data() + j * width;
        const float* upper = lower + width;
        for (std::size_t i = 0; i < cells; ++i) {
            const std::size_t right = i + 1, odd = (i + j) & 1;
            moving_[0][j * cells + i] = std::max({lower[i], lower[right], upper[odd ? i : right]});
            moving_[1][j * cells + i] = std::max({upper[i], upper[right], lower[odd ? right : i]});
        }
    }
}

numerics::EdgePair<float> PlaneFilm::edges(int triangle, const PlaneVector& displacement) const {
    const int cell = triangle / 2, row = cell / (columns_ - 1),
              column = cell - row * (columns_ - 1);
    const bool second = triangle % 2 != 0, even = (column + row) % 2 == 0;
    return cellEdges(rowOfPoints(displacement, std::size_t(columns_), row), std::size_t(column),
                     second, even != second, 1 / inverseX_, 1 / inverseZ_);
}

// Whether some free triangle of a row of cells may be torn: neither its larger stretch nor, with
// λ1 λ2 ≤ (λ1² + λ2²)/2, its area can be past the limit while the sum of squares is small.
bool PlaneFilm::mayTear(int row, const PlaneVector& displacement, float limit) const {
    const std::size_t cells = std::size_t(columns_ - 1), first = std::size_t(row) * cells;
    const float most =
        largestSquare(cells, unsigned(row), rowOfPoints(displacement, std::size_t(columns_), row),
                      {moving_[0].data() + first, moving_[1].data() + first}, inverseX_, inverseZ_);
    return most > std::min(limit * limit, 2 * limit);
}

void PlaneFilm::setCrossing(std::vector<Crossing> triangles) {
    crossing_ = std::move(triangles);
    anchors_.resize(crossing_.size());
    firstCrossing_.assign(std::size_t(rows_), 0);
    for (const Crossing& triangle : crossing_) {
        ++firstCrossing_[triangle.cell / std::size_t(columns_ - 1) + 1];
    }
    for (std::size_t row = 1; row < firstCrossing_.size(); ++row) {
        firstCrossing_[row] += firstCrossing_[row - 1];
    }
}

std::pair<std::size_t, std::size_t> PlaneFilm::crossingInRow(int row) const {
    if (crossing_.empty()) {
        return {0, 0};
    }
    return {firstCrossing_[std::size_t(row)], firstCrossing_[std::size_t(row) + 1]};
}

double PlaneFilm::gradient(const PlaneVector& displacement, PlaneVector& result) {
    const std::size_t width = std::size_t(columns_), cells = width - 1;
    const Matrix2<float> common{inverseX_, 0, 0, inverseZ_};
    std::vector<double> squares(std::size_t(rows_ - 1), 0.0);
    gatherForces(columns_, rows_, result, [&](int j, bool owned, EdgeForces& forces) {
        const std::size_t first = std::size_t(j) * cells;
        const ShapePointers shapes[2] = {
            {inverseShape_[0].a.data() + first, inverseShape_[0].b.data() + first,
             inverseShape_[0].c.data() + first, inverseShape_[0].d.data() + first},
            {inverseShape_[1].a.data() + first, inverseShape_[1].b.data() + first,
             inverseShape_[1].c.data() + first, inverseShape_[1].d.data() + first}};
        // A row of cells between two bands is computed for both; only one keeps its states.
        std::vector<float> spare;
        if (!owned) {
            spare.resize(6 * cells);
        }
        const auto keep = [&](std::vector<float>& array, std::size_t which) {
            return owned ? array.data() + first : spare.data() + which * cells;
        };
        const MutableStatePointers states[2] = {
            {keep(state_[0].cosine, 0), keep(state_[0].sine, 1), keep(state_[0].turn, 2)},
            {keep(state_[1].cosine, 3), keep(state_[1].sine, 4), keep(state_[1].turn, 5)}};
        gradientRow(crept_[std::size_t(j)] != 0, cells, unsigned(j) & 1u,
                    rowOfPoints(displacement, width, j), shapes, common, 1 / inverseX_,
                    1 / inverseZ_, area_, states, rowOfForces(forces));
        const auto [begin, end] = crossingInRow(j);
        for (std::size_t k = begin; k < end; ++k) { // these few once more, by themselves
            const Crossing& triangle = crossing_[k];
            const std::size_t i = triangle.cell - first;
            const bool second = triangle.second;
            StressState<float> state;
            const Matrix2<float> P =
                stress(floatingGradient(anchors_[k], wholeGradient(triangle, displacement)), state);
            states[second].cosine[i] = state.cosine;
            states[second].sine[i] = state.sine;
            states[second].turn[i] = state.turn;
            putForces(
                forces, i, triangle,
                numerics::crossingForces(triangle, P, inverseShape(triangle.cell, second), area_));
        }
        if (owned) {
            for (const int which : {firstX, firstZ, secondX, secondZ}) {
                const std::vector<float>& moving = moving_[which == secondX || which == secondZ];
                squares[std::size_t(j)] +=
                    rowWeightedSquares(moving.data() + first, forces.array(which), cells);
            }
        }
    });
    double sum = 0;
    for (const double square : squares) {
        sum += square;
    }
    return std::sqrt(sum);
}

void PlaneFilm::hessian(const PlaneVector& direction, PlaneVector& result) const {
    const std::size_t width = std::size_t(columns_), cells = width - 1;
    const Matrix2<float> common{inverseX_, 0, 0, inverseZ_};
    gatherForces(columns_, rows_, result, [&](int j, bool, EdgeForces& forces) {
        const std::size_t first = std::size_t(j) * cells;
        const ShapePointers shapes[2] = {
            {inverseShape_[0].a.data() + first, inverseShape_[0].b.data() + first,
             inverseShape_[0].c.data() + first, inverseShape_[0].d.data() + first},
            {inverseShape_[1].a.data() + first, inverseShape_[1].b.data() + first,
             inverseShape_[1].c.data() + first, inverseShape_[1].d.data() + first}};
        const StatePointers states[2] = {
            {state_[0].cosine.data() + first, state_[0].sine.data() + first,
             state_[0].turn.data() + first},
            {state_[1].cosine.data() + first, state_[1].sine.data() + first,
             state_[1].turn.data() + first}};
        hessianRow(crept_[std::size_t(j)] != 0, cells, unsigned(j) & 1u,
                   rowOfPoints(direction, width, j), shapes, common, area_, states,
                   rowOfForces(forces));
        const auto [begin, end] = crossingInRow(j);
        for (std::size_t k = begin; k < end; ++k) {
            const Crossing& triangle = crossing_[k];
            const std::size_t i = triangle.cell - first;
            const bool second = triangle.second, right = triangle.thirdOnRight;
            const Matrix2<float> shape = inverseShape(triangle.cell, second);
            const StressState<float> state{states[second].cosine[i], states[second].sine[i],
                                           states[second].turn[i]};
            const CellEdges edges =
                cellEdges(rowOfPoints(direction, width, j), i, second, right, 0, 0);
            putForces(
                forces, i, triangle,
                numerics::crossingForces(
                    triangle,
                    stressDerivative(floatingChange(anchors_[k], gradientOf(edges, shape)), state),
                    shape, area_));
        }
    });
}

} // namespace dipwright::cpu

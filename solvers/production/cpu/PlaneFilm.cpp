#include "production/cpu/PlaneFilm.h"

#include "common/cpu/RowParallel.h"
#include "production/formulas/EdgeStiffness.h"
#include "production/formulas/PlaneStress.h"
#include "production/formulas/TearLaw.h"

#include <algorithm>
#include <iterator>

namespace dipwright::cpu {

using numerics::gradientOf;
using numerics::Matrix2;
using numerics::StressState;
using numerics::Tangent;

namespace {

// The forces on the edges of one row of cells: on the lower (first) and upper (second) horizontal
// edges, and each cell's contribution to its left and right vertical edges.
struct EdgeForces {
    explicit EdgeForces(std::size_t cells) : pitch((cells / 16 + 1) * 16), storage(8 * pitch) {}
    float* array(int which) { return storage.data() + std::size_t(which) * pitch; }
    std::size_t pitch;
    AlignedVector<float> storage;
};
enum { firstX, firstZ, secondX, secondZ, leftX, leftZ, rightX, rightZ };

RowOfForces rowOfForces(EdgeForces& forces) {
    return {forces.array(firstX),  forces.array(firstZ), forces.array(secondX),
            forces.array(secondZ), forces.array(leftX),  forces.array(leftZ),
            forces.array(rightX),  forces.array(rightZ)};
}

// Calls cellRow(j, owned, forces) for each row of cells, to compute the forces on its edges.
// Collects the forces on the points in `result`, and calls finish(row) for each complete row. Two
// bands compute the row of cells between them; `owned` is true for only one of them.
template <typename CellRow>
void gatherForces(int columns, int rows, PlaneVector& result, const CellRow& cellRow,
                  const PlaneFilm::RowWork& finish) {
    const std::size_t width = std::size_t(columns), cells = width - 1;
    forRowBands(rows, columns, [&](int begin, int end) {
        EdgeForces forces(cells);
        const auto clear = [&](int row) {
            std::fill_n(result.x.data() + std::size_t(row) * width, width, 0.f);
            std::fill_n(result.z.data() + std::size_t(row) * width, width, 0.f);
        };
        const auto give = [&](int row, float sign, int edgeX, int edgeZ) {
            addForces(cells, sign, forces.array(edgeX), forces.array(leftX), forces.array(rightX),
                      result.x.data() + std::size_t(row) * width);
            addForces(cells, sign, forces.array(edgeZ), forces.array(leftZ), forces.array(rightZ),
                      result.z.data() + std::size_t(row) * width);
        };
        clear(begin);
        for (int j = std::max(begin - 1, 0); j < std::min(end, rows - 1); ++j) {
            const bool hasLower = j >= begin, hasUpper = j + 1 < end;
            cellRow(j, hasLower, forces);
            if (hasLower) {
                give(j, -1, firstX, firstZ);
                finish(j);
            }
            if (hasLower && hasUpper) {
                clear(j + 1);
            }
            if (hasUpper) {
                give(j + 1, 1, secondX, secondZ);
            }
        }
        if (end == rows) {
            finish(end - 1);
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

PlaneFilm::PlaneFilm(const numerics::FilmModel<float>& model)
    : columns_(model.columns), rows_(model.rows), model_(model) {
    const auto inverses = [](const float* edges, int count) {
        std::vector<float> result;
        std::transform(edges, edges + count, std::back_inserter(result),
                       [](float edge) { return 1 / edge; });
        return result;
    };
    inversesX_ = inverses(model.alongX.edges, columns_ - 1);
    inversesZ_ = inverses(model.alongZ.edges, rows_ - 1);
    const std::size_t cells = std::size_t(columns_ - 1) * std::size_t(rows_ - 1);
    for (States& state : state_) {
        state.cosine.assign(cells, 1.f);
        state.sine.assign(cells, 0.f);
        state.turn.assign(cells, -1.f);
        state.resists.assign(cells, 1.f);
    }
    moving_[0] = moving_[1] = std::vector<float>(cells, 1.f);
    crept_.assign(std::size_t(rows_ - 1), 0);
    for (TriangleArrays& shape : inverseShape_) {
        shape.b.assign(cells, 0.f);
        shape.c.assign(cells, 0.f);
        for (int row = 0; row + 1 < rows_; ++row) {
            shape.a.insert(shape.a.end(), inversesX_.begin(), inversesX_.end());
            shape.d.insert(shape.d.end(), inversesX_.size(), inversesZ_[std::size_t(row)]);
        }
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
    forRows(rows_ - 1, columns_, [&](int row) {
        const std::size_t j = std::size_t(row);
        const float* lower = free.data() + j * width;
        const float* upper = lower + width;
        for (std::size_t i = 0; i < cells; ++i) {
            const std::size_t right = i + 1, odd = (i + j) & 1;
            moving_[0][j * cells + i] = std::max({lower[i], lower[right], upper[odd ? i : right]});
            moving_[1][j * cells + i] = std::max({upper[i], upper[right], lower[odd ? right : i]});
        }
    });
}

numerics::EdgePair<float> PlaneFilm::edges(int triangle, const PlaneVector& displacement) const {
    const int cell = triangle / 2, row = cell / (columns_ - 1),
              column = cell - row * (columns_ - 1);
    const bool second = triangle % 2 != 0, even = (column + row) % 2 == 0;
    return cellEdges(rowOfPoints(displacement, std::size_t(columns_), row), std::size_t(column),
                     second, even != second, model_.alongX.edges[column], model_.alongZ.edges[row]);
}

// Returns whether a free triangle of a row of cells may be torn or folded.
bool PlaneFilm::mayBeTornOrFolded(int row, const PlaneVector& displacement, float limit) const {
    const std::size_t cells = std::size_t(columns_ - 1), first = std::size_t(row) * cells;
    const StretchRange range =
        stretchRange(cells, unsigned(row), rowOfPoints(displacement, std::size_t(columns_), row),
                     {moving_[0].data() + first, moving_[1].data() + first}, sizesOf(row));
    return numerics::mayBeTornOrFolded(range.largestSquares, range.leastArea, limit);
}

void PlaneFilm::relaxFloating(const PlaneVector& displacement, float keep) {
    const std::size_t width = std::size_t(columns_), cells = width - 1;
    forRowBands(rows_ - 1, columns_, [&](int begin, int end) {
        std::vector<float> relaxed(4 * cells);
        for (int row = begin; row < end; ++row) {
            const auto [next, last] = crossingInRow(row);
            std::vector<Matrix2<float>> onLine;
            for (std::size_t k = next; k < last; ++k) {
                onLine.push_back(inverseShape(crossing_[k].cell, crossing_[k].second));
            }
            for (const bool second : {false, true}) {
                relaxRow(cells, unsigned(row) & 1u, second, rowOfPoints(displacement, width, row),
                         shapesOf(row), keep, {relaxed.data(), cells});
                TriangleArrays& to = inverseShape_[second];
                const float* from = relaxed.data();
                for (AlignedVector<float>* array : {&to.a, &to.b, &to.c, &to.d}) {
                    std::copy_n(from, cells, array->begin() + std::ptrdiff_t(cells) * row);
                    from += cells;
                }
            }
            for (std::size_t k = next; k < last; ++k) {
                setInverseShape(crossing_[k].cell, crossing_[k].second, onLine[k - next]);
            }
            crept_[std::size_t(row)] = 1;
        }
    });
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

RowOfSizes PlaneFilm::sizesOf(int row) const {
    return {model_.alongX.edges, inversesX_.data(), model_.alongZ.edges[row],
            inversesZ_[std::size_t(row)]};
}

float PlaneFilm::areaOf(const Crossing& triangle) const {
    return triangleSize(model_, numberOf(triangle)).area();
}

RowOfShapes PlaneFilm::shapesOf(int row) const {
    const std::size_t first = std::size_t(row) * std::size_t(columns_ - 1);
    RowOfShapes shapes{crept_[std::size_t(row)] != 0, {}, sizesOf(row)};
    for (std::size_t second = 0; second < 2; ++second) {
        const TriangleArrays& from = inverseShape_[second];
        shapes.shapes[second] = {from.a.data() + first, from.b.data() + first,
                                 from.c.data() + first, from.d.data() + first};
    }
    return shapes;
}

double PlaneFilm::gradient(const PlaneVector& displacement, PlaneVector& result,
                           const RowWork& finish) {
    const std::size_t width = std::size_t(columns_), cells = width - 1;
    std::vector<numerics::SquareSum> squares(std::size_t(rows_ - 1));
    const auto cellRow = [&](int j, bool owned, EdgeForces& forces) {
        const std::size_t first = std::size_t(j) * cells;
        // Both bands compute the row of cells between them, but only one band keeps its states.
        std::vector<float> spare;
        if (!owned) {
            spare.resize(8 * cells);
        }
        const auto keep = [&](AlignedVector<float>& array, std::size_t which) {
            return owned ? array.data() + first : spare.data() + which * cells;
        };
        RowOfStates<float*> states;
        for (std::size_t second = 0; second < 2; ++second) {
            States& to = state_[second];
            states.states[second] = {keep(to.cosine, 4 * second), keep(to.sine, 4 * second + 1),
                                     keep(to.turn, 4 * second + 2),
                                     keep(to.resists, 4 * second + 3)};
        }
        gradientRow(cells, unsigned(j) & 1u, rowOfPoints(displacement, width, j), shapesOf(j),
                    model_.gatheredResistance, states, rowOfForces(forces));
        const auto [begin, end] = crossingInRow(j);
        // Recomputes the few triangles that cross the contact line.
        for (std::size_t k = begin; k < end; ++k) {
            const Crossing& triangle = crossing_[k];
            const std::size_t i = triangle.cell - first;
            StressState<float> state;
            const Matrix2<float> P =
                stress(floatingGradient(anchors_[k], wholeGradient(triangle, displacement)),
                       model_.gatheredResistance, state);
            const RowOfStates<float*>::Pointers& to = states.states[triangle.second];
            to.cosine[i] = state.cosine;
            to.sine[i] = state.sine;
            to.turn[i] = state.turn;
            to.resists[i] = state.resists;
            putForces(forces, i, triangle,
                      numerics::crossingForces(triangle, P,
                                               inverseShape(triangle.cell, triangle.second),
                                               areaOf(triangle)));
        }
        if (owned) {
            numerics::SquareSum& sum = squares[std::size_t(j)];
            sum = rowWeightedSquares(moving_[0].data() + first,
                                     {forces.array(firstX), forces.array(firstZ)}, cells);
            sum.add(rowWeightedSquares(moving_[1].data() + first,
                                       {forces.array(secondX), forces.array(secondZ)}, cells));
        }
    };
    gatherForces(columns_, rows_, result, cellRow, finish);
    return sumOf(squares).root();
}

RowOfStates<const float*> PlaneFilm::statesOf(int row) const {
    const std::size_t first = std::size_t(row) * std::size_t(columns_ - 1);
    RowOfStates<const float*> states;
    for (std::size_t second = 0; second < 2; ++second) {
        states.states[second] = {
            state_[second].cosine.data() + first, state_[second].sine.data() + first,
            state_[second].turn.data() + first, state_[second].resists.data() + first};
    }
    return states;
}

void PlaneFilm::hessian(const PlaneVector& direction, Tangent tangent, PlaneVector& result,
                        const RowWork& finish) const {
    const std::size_t width = std::size_t(columns_), cells = width - 1;
    const auto cellRow = [&](int j, bool, EdgeForces& forces) {
        const std::size_t first = std::size_t(j) * cells;
        const RowOfPoints points = rowOfPoints(direction, width, j);
        hessianRow(cells, unsigned(j) & 1u, points, shapesOf(j), statesOf(j), tangent,
                   rowOfForces(forces));
        const auto [begin, end] = crossingInRow(j);
        for (std::size_t k = begin; k < end; ++k) {
            const Crossing& triangle = crossing_[k];
            const Matrix2<float> shape = inverseShape(triangle.cell, triangle.second);
            const numerics::EdgePair<float> edges = cellEdges(
                points, triangle.cell - first, triangle.second, triangle.thirdOnRight, 0, 0);
            const Matrix2<float> change = floatingChange(anchors_[k], gradientOf(edges, shape));
            putForces(forces, triangle.cell - first, triangle,
                      numerics::crossingForces(triangle,
                                               stressDerivative(change, stateOf(triangle), tangent),
                                               shape, areaOf(triangle)));
        }
    };
    gatherForces(columns_, rows_, result, cellRow, finish);
}

StressState<float> PlaneFilm::stateOf(const Crossing& triangle) const {
    const States& states = state_[triangle.second];
    return {states.cosine[triangle.cell], states.sine[triangle.cell], states.turn[triangle.cell],
            states.resists[triangle.cell]};
}

void PlaneFilm::stiffness(int row, const Lines<float>& first, const Lines<float>& second) const {
    const std::size_t cells = std::size_t(columns_ - 1);
    stiffnessRow(cells, shapesOf(row), statesOf(row), first, second);
    const auto [begin, end] = crossingInRow(row);
    for (std::size_t k = begin; k < end; ++k) {
        const Crossing& triangle = crossing_[k];
        const numerics::EdgeStiffness<float> stiffness =
            edgeStiffness(triangle, anchors_[k], inverseShape(triangle.cell, triangle.second),
                          stateOf(triangle), areaOf(triangle));
        const std::size_t i = triangle.cell - std::size_t(row) * cells;
        std::size_t line = 0;
        for (const Matrix2<float>& block :
             {stiffness.hh, stiffness.hv, stiffness.vh, stiffness.vv}) {
            for (const float value : {block.a, block.b, block.c, block.d}) {
                (triangle.second ? second : first)[line++][i] = value;
            }
        }
    }
}

} // namespace dipwright::cpu

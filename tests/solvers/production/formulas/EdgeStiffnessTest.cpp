// Compares the stiffness of a triangle's edges with differences of its forces, and the rows of a
// cell with the sum of the cell's two triangles.

#include "production/formulas/EdgeStiffness.h"

#include <QTest>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace dipwright::numerics;

namespace {

const double resistance = gatheredResistance(0.8); // resistance of gathered film

using Matrix = Matrix2<double>;
using Edges = EdgePair<double>;
using Four = std::array<double, 4>; // hx, hz, vx, vz
// Derivative of the force (row) with respect to the edge (column).
using Square = std::array<Four, 4>;

const Matrix shape{0.6, 0.05, -0.1, 0.8};
constexpr double area = 0.7;

Four numbers(const Edges& edges) {
    return {edges.hx, edges.hz, edges.vx, edges.vz};
}
Edges edgesOf(const Four& n) {
    return {n[0], n[1], n[2], n[3]};
}

Square square(const EdgeStiffness<double>& k) {
    return {{{k.hh.a, k.hh.b, k.hv.a, k.hv.b},
             {k.hh.c, k.hh.d, k.hv.c, k.hv.d},
             {k.vh.a, k.vh.b, k.vv.a, k.vv.b},
             {k.vh.c, k.vh.d, k.vv.c, k.vv.d}}};
}

Square differences(const std::function<Edges(const Edges&)>& force, const Edges& edges) {
    const double h = 1e-6;
    Square slopes{};
    for (std::size_t moved = 0; moved < 4; ++moved) {
        Four ahead = numbers(edges), behind = ahead;
        ahead[moved] += h;
        behind[moved] -= h;
        const Four more = numbers(force(edgesOf(ahead))), less = numbers(force(edgesOf(behind)));
        for (std::size_t k = 0; k < 4; ++k) {
            slopes[k][moved] = (more[k] - less[k]) / (2 * h);
        }
    }
    return slopes;
}

double distance(const Square& a, const Square& b) {
    double most = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t m = 0; m < 4; ++m) {
            most = std::max(most, std::abs(a[k][m] - b[k][m]));
        }
    }
    return most;
}

Edges edgesWith(const Matrix& F) {
    const Matrix edges = F * inverse(shape);
    return {edges.a, edges.c, edges.b, edges.d};
}

Matrix turned(double angle, const Matrix& F) {
    return Matrix{std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)} * F;
}

// Returns deformations for which the projected derivative is the true derivative: both coefficients
// are at least −1.
std::vector<Matrix> firmFilm() {
    return {{1.1, 0, 0, 1.05},
            {1.3, 0.2, -0.1, 1.1},
            {3, 0.1, 0.2, 0.9}, // stretched
            turned(2.1, {1.2, 0.1, 0.1, 1})};
}
// Returns deformations for which the two derivatives differ: about to gather, gathered, rotated and
// gathered, inside out.
std::vector<Matrix> gatheredFilm() {
    return {{0.85, 0.02, 0, 0.77},
            {0.6, 0.1, 0, 0.7},
            turned(-1.2, {0.5, 0.1, 0, 0.4}),
            {1, 0, 0.1, -0.2}};
}

// Returns the stress to first order about F with the projected coefficients. Its derivative is the
// projected derivative; for firm film that is the true derivative.
Matrix stressNear(const Matrix& F, const Matrix& now) {
    StressState<double> state;
    const Matrix at = stress(F, resistance, state);
    const Matrix change = stressDerivative(
        Matrix{now.a - F.a, now.b - F.b, now.c - F.c, now.d - F.d}, state, Tangent::Projected);
    return {at.a + change.a, at.b + change.b, at.c + change.c, at.d + change.d};
}

EdgeStiffness<double> stiffnessAt(const Matrix& F) {
    StressState<double> state;
    stress(F, resistance, state);
    return edgeStiffness(shape, state, area);
}

// The stiffness of a cell for eight numbers: x and z of the lower left, lower right, upper left and
// upper right point.
using Cell = std::array<std::array<double, 8>, 8>;

void addTriangle(Cell& cell, const EdgeStiffness<double>& stiffness, bool isUpper, bool onRight) {
    const std::size_t left = isUpper ? 2 : 0;  // the ends of the horizontal edge
    const std::size_t lower = onRight ? 1 : 0; // the ends of the vertical edge
    const std::size_t ends[2][2] = {{left, left + 1}, {lower, lower + 2}};
    const Square k = square(stiffness);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            for (std::size_t of = 0; of < 2; ++of) {
                for (std::size_t by = 0; by < 2; ++by) {
                    cell[2 * ends[row / 2][of] + row % 2][2 * ends[column / 2][by] + column % 2] +=
                        (of == by ? 1 : -1) * k[row][column];
                }
            }
        }
    }
}

template <CellPoint point>
bool isRowOf(const Cell& cell, const CellRow<double>& row) {
    const Matrix* to[] = {&row.toLowerLeft, &row.toLowerRight, &row.toUpperLeft, &row.toUpperRight};
    const std::size_t own = 2 * std::size_t(point);
    bool isSame = true;
    for (std::size_t other = 0; other < 4; ++other) {
        const double expected[] = {cell[own][2 * other], cell[own][2 * other + 1],
                                   cell[own + 1][2 * other], cell[own + 1][2 * other + 1]};
        const double found[] = {to[other]->a, to[other]->b, to[other]->c, to[other]->d};
        for (std::size_t k = 0; k < 4; ++k) {
            isSame = isSame && std::abs(expected[k] - found[k]) < 1e-12;
        }
    }
    return isSame;
}

} // namespace

class EdgeStiffnessTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void edgeStiffness_firmFilm_isTheForcesDerivative();
    void edgeStiffness_gatheredFilm_isTheProjectedDerivative();
    void edgeStiffness_isSymmetricAndSemiDefinite();
    void edgeStiffness_crossingTriangle_isTheForcesDerivative();
    void cellRow_isTheSumOfItsTwoTriangles();
};

void EdgeStiffnessTest::edgeStiffness_firmFilm_isTheForcesDerivative() {
    for (const Matrix& F : firmFilm()) {
        const auto force = [](const Edges& edges) {
            StressState<double> state;
            return edgeForces(stress(gradientOf(edges, shape), resistance, state), shape, area);
        };
        QVERIFY(distance(square(stiffnessAt(F)), differences(force, edgesWith(F))) < 1e-7);
    }
}

void EdgeStiffnessTest::edgeStiffness_gatheredFilm_isTheProjectedDerivative() {
    for (const Matrix& F : gatheredFilm()) {
        const auto force = [&](const Edges& edges) {
            return edgeForces(stressNear(F, gradientOf(edges, shape)), shape, area);
        };
        QVERIFY(distance(square(stiffnessAt(F)), differences(force, edgesWith(F))) < 1e-7);
    }
}

void EdgeStiffnessTest::edgeStiffness_isSymmetricAndSemiDefinite() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    for (int i = 0; i < 2000; ++i) {
        const Square k =
            square(stiffnessAt({number(random), number(random), number(random), number(random)}));
        const Four way{number(random), number(random), number(random), number(random)};
        double work = 0;
        for (std::size_t row = 0; row < 4; ++row) {
            for (std::size_t column = 0; column < 4; ++column) {
                QVERIFY(std::abs(k[row][column] - k[column][row]) < 1e-12);
                work += way[row] * k[row][column] * way[column];
            }
        }
        QVERIFY(work > -1e-9);
    }
}

// Each corner may be held or free, in any position of the triangle in its cell.
void EdgeStiffnessTest::edgeStiffness_crossingTriangle_isTheForcesDerivative() {
    for (int corners = 1; corners < 7; ++corners) {
        for (int way = 0; way < 4; ++way) {
            CrossingTriangle<double> triangle;
            triangle.second = way % 2 != 0;
            triangle.thirdOnRight = way / 2 != 0;
            triangle.sharedFree = (corners & 1) != 0;
            triangle.horizontalFree = (corners & 2) != 0;
            triangle.verticalFree = (corners & 4) != 0;
            triangle.horizontalShare = 0.4;
            triangle.verticalShare = 0.9;
            triangle.diagonalShare = 0.6;
            triangle.normalX = 0.6;
            triangle.normalZ = 0.8;
            triangle.floating = 0.5;
            for (const std::vector<Matrix>& film : {firmFilm(), gatheredFilm()}) {
                const Matrix& whole = film.front();
                const CrossingAnchor<double> anchor =
                    anchorOverStep(crossingAnchor(triangle, Matrix{1.02, 0, 0.01, 0.97}), triangle);
                const Matrix F = floatingGradient(anchor, whole);
                StressState<double> state;
                stress(F, resistance, state);
                const auto force = [&](const Edges& edges) {
                    return crossingForces(
                        triangle, stressNear(F, floatingGradient(anchor, gradientOf(edges, shape))),
                        shape, area);
                };
                QVERIFY(distance(square(edgeStiffness(triangle, anchor, shape, state, area)),
                                 differences(force, edgesWith(whole))) < 1e-7);
            }
        }
    }
}

void EdgeStiffnessTest::cellRow_isTheSumOfItsTwoTriangles() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto block = [&] {
        return Matrix{number(random), number(random), number(random), number(random)};
    };
    for (const bool even : {false, true}) {
        const EdgeStiffness<double> first{block(), block(), block(), block()};
        const EdgeStiffness<double> second{block(), block(), block(), block()};
        Cell cell{};
        addTriangle(cell, first, false, even);
        addTriangle(cell, second, true, !even);
        const auto agrees = [&]<CellPoint point>() {
            return isRowOf<point>(cell, cellRow<point>(first, second, even));
        };
        QVERIFY(agrees.operator()<CellPoint::LowerLeft>());
        QVERIFY(agrees.operator()<CellPoint::LowerRight>());
        QVERIFY(agrees.operator()<CellPoint::UpperLeft>());
        QVERIFY(agrees.operator()<CellPoint::UpperRight>());
    }
}

QTEST_GUILESS_MAIN(EdgeStiffnessTest)
#include "EdgeStiffnessTest.moc"

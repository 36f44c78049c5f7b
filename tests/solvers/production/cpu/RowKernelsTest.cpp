// Compares the row kernels in vector instructions with scalar arithmetic, bit for bit, for rows of
// every length.

#include "production/cpu/RowKernels.h"
#include "RandomRows.h"

#include "production/formulas/EdgeStiffness.h"

#include <QTest>
#include <algorithm>
#include <limits>
#include <vector>

using namespace dipwright;
using namespace dipwright::cpu;
using numerics::Tangent;
using test::haveSameBits;
using test::randomRow;
using test::Row;

namespace {

constexpr float resistance = -1.5f; // resistance of gathered film
constexpr std::size_t longest = 70; // four of the longest vectors and a remainder

// Two rows of displaced points, and the shapes of the cells between them.
struct Cells {
    explicit Cells(std::size_t count)
        : cells(count), x0(randomRow(count + 1, 1, -0.2f, 0.2f)),
          z0(randomRow(count + 1, 2, -0.2f, 0.2f)), x1(randomRow(count + 1, 3, -0.2f, 0.2f)),
          z1(randomRow(count + 1, 4, -0.2f, 0.2f)), edgesX(randomRow(count, 7, 0.8f, 1.2f)),
          inversesX(randomRow(count, 8, 0.8f, 1.2f)) {
        for (unsigned k = 0; k < 8; ++k) {
            const bool isDiagonal = k % 4 == 0 || k % 4 == 3;
            shapes.push_back(
                randomRow(count, 10 + k, isDiagonal ? 0.9f : -0.1f, isDiagonal ? 1.1f : 0.1f));
        }
    }
    RowOfSizes sizes() const { return {edgesX.data(), inversesX.data(), edgeZ, inverseZ}; }
    float area(std::size_t i) const { return edgesX[i] * edgeZ / 2; }
    RowOfPoints points() const { return {x0.data(), z0.data(), x1.data(), z1.data()}; }
    RowOfShapes rowOfShapes(bool isCrept) const {
        RowOfShapes row{isCrept, {}, sizes()};
        for (std::size_t second = 0; second < 2; ++second) {
            row.shapes[second] = {shapes[4 * second].data(), shapes[4 * second + 1].data(),
                                  shapes[4 * second + 2].data(), shapes[4 * second + 3].data()};
        }
        return row;
    }
    numerics::Matrix2<float> shape(bool isCrept, bool second, std::size_t i) const {
        const std::size_t k = 4 * std::size_t(second);
        return isCrept ? numerics::Matrix2<float>{shapes[k][i], shapes[k + 1][i], shapes[k + 2][i],
                                                  shapes[k + 3][i]}
                       : numerics::Matrix2<float>{inversesX[i], 0, 0, inverseZ};
    }

    std::size_t cells;
    Row x0, z0, x1, z1;
    Row edgesX, inversesX; // a graded film
    std::vector<Row> shapes;
    static constexpr float edgeZ = 0.97f, inverseZ = 1.03f;
};

// The forces on the edges of a row of cells, and the states of the cells, filled cell by cell.
struct Edges {
    explicit Edges(std::size_t count) : arrays(8, Row(count)), states(8, Row(count)) {}
    RowOfForces forces() {
        return {arrays[0].data(), arrays[1].data(), arrays[2].data(), arrays[3].data(),
                arrays[4].data(), arrays[5].data(), arrays[6].data(), arrays[7].data()};
    }
    RowOfStates<float*> rowOfStates() {
        RowOfStates<float*> row;
        for (std::size_t second = 0; second < 2; ++second) {
            const std::size_t k = 4 * second;
            row.states[second] = {states[k].data(), states[k + 1].data(), states[k + 2].data(),
                                  states[k + 3].data()};
        }
        return row;
    }
    RowOfStates<const float*> constStates() const {
        RowOfStates<const float*> row;
        for (std::size_t second = 0; second < 2; ++second) {
            const std::size_t k = 4 * second;
            row.states[second] = {states[k].data(), states[k + 1].data(), states[k + 2].data(),
                                  states[k + 3].data()};
        }
        return row;
    }
    void put(std::size_t i, bool second, bool right, const numerics::EdgePair<float>& force) {
        arrays[second ? 2 : 0][i] = force.hx;
        arrays[second ? 3 : 1][i] = force.hz;
        arrays[right ? 6 : 4][i] = force.vx;
        arrays[right ? 7 : 5][i] = force.vz;
    }
    bool operator==(const Edges& other) const {
        return std::ranges::equal(arrays, other.arrays, haveSameBits) &&
               std::ranges::equal(states, other.states, haveSameBits);
    }
    std::vector<Row> arrays, states;
};

// Returns whether the sums over a row are the same as term by term.
bool rowSumsEqualScalarBits(const Row& ax, const Row& az) {
    const float factor = 1.7f;
    const std::size_t count = ax.size();
    const Row bx = randomRow(count, 3), bz = randomRow(count, 4), w = randomRow(count, 5, 0, 1);
    std::int64_t products = 0;
    numerics::SquareSum squares, weighted;
    for (std::size_t i = 0; i < count; ++i) {
        const float product = ax[i] * bx[i] + az[i] * bz[i];
        const float square = ax[i] * ax[i] + az[i] * az[i];
        products += numerics::ProductSum::multiple(double(product) * double(factor));
        squares.add(double(square));
        weighted.add(double(w[i] * square));
    }
    const RowOfPairs a{ax.data(), az.data()}, b{bx.data(), bz.data()};
    const auto areEqual = [](const numerics::SquareSum& one, const numerics::SquareSum& other) {
        return one.coarse == other.coarse && one.rest == other.rest;
    };
    return rowProducts(a, b, factor, count) == products &&
           areEqual(rowSquares(a, count), squares) &&
           areEqual(rowWeightedSquares(w.data(), a, count), weighted);
}

} // namespace

class RowKernelsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void rowSums_everyLength_equalScalarBits();
    void rowSums_termsOutOfRange_equalScalarBits();
    void rowLargest_ignoresNaN();
    void rowCombinations_everyLength_equalScalarBits();
    void gradientAndHessianRow_everyLength_equalScalarBits();
    void stiffnessRow_everyLength_equalsScalarBits();
    void addForces_everyLength_equalsScalarBits();
    void relaxRow_everyLength_equalsScalarBits();
    void stretchRange_everyLength_equalsScalarBits();
};

void RowKernelsTest::rowSums_everyLength_equalScalarBits() {
    for (std::size_t count = 0; count <= longest; ++count) {
        QVERIFY(rowSumsEqualScalarBits(randomRow(count, 1), randomRow(count, 2)));
    }
}

// One such term at each place of a row, in the vectors and in the remainder.
void RowKernelsTest::rowSums_termsOutOfRange_equalScalarBits() {
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float bad :
         {infinite, -infinite, std::numeric_limits<float>::quiet_NaN(), 1e6f, -1e6f}) {
        for (std::size_t place = 0; place < longest; ++place) {
            Row x = randomRow(longest, 1);
            x[place] = bad;
            QVERIFY(rowSumsEqualScalarBits(x, randomRow(longest, 2)));
        }
    }
}

void RowKernelsTest::rowLargest_ignoresNaN() {
    for (std::size_t count = 1; count <= longest; ++count) {
        for (std::size_t place = 0; place < count; ++place) {
            Row row = randomRow(count, 1);
            row[place] = 0;
            const float largest = rowLargest(row.data(), count);
            row[place] = std::numeric_limits<float>::quiet_NaN();
            QVERIFY(rowLargest(row.data(), count) == largest);
            row[place] = -2;
            QVERIFY(rowLargest(row.data(), count) == 2);
        }
    }
}

void RowKernelsTest::rowCombinations_everyLength_equalScalarBits() {
    for (std::size_t count = 0; count <= longest; ++count) {
        const Row a = randomRow(count, 1), b = randomRow(count, 2), c = randomRow(count, 3);
        const float factor = 0.37f;
        Row out = c, expected = c;
        const auto check = [&](const auto& one) {
            for (std::size_t i = 0; i < count; ++i) {
                expected[i] = one(i, expected[i]);
            }
            return haveSameBits(out, expected);
        };
        addScaled(count, factor, a.data(), out.data());
        QVERIFY(check([&](std::size_t i, float was) { return was + factor * a[i]; }));
        scaledRow(count, factor, a.data(), out.data());
        QVERIFY(check([&](std::size_t i, float) { return factor * a[i]; }));
        addWeighted(count, factor, b.data(), a.data(), out.data());
        QVERIFY(check([&](std::size_t i, float was) { return was + factor * b[i] * a[i]; }));
        addDifference(count, factor, c.data(), a.data(), b.data(), out.data());
        QVERIFY(
            check([&](std::size_t i, float was) { return was + factor * c[i] * (a[i] - b[i]); }));
        multiplyBy(count, b.data(), out.data());
        QVERIFY(check([&](std::size_t i, float was) { return was * b[i]; }));
    }
}

void RowKernelsTest::gradientAndHessianRow_everyLength_equalScalarBits() {
    for (std::size_t count = 1; count <= longest; ++count) {
        const Cells film(count);
        for (const bool isCrept : {false, true}) {
            for (const unsigned parity : {0u, 1u}) {
                const Tangent tangent = parity == 0 ? Tangent::True : Tangent::Projected;
                Edges gradient(count), expected(count);
                gradientRow(count, parity, film.points(), film.rowOfShapes(isCrept), resistance,
                            gradient.rowOfStates(), gradient.forces());
                Edges hessian = gradient, expectedHessian = gradient;
                hessianRow(count, parity, film.points(), film.rowOfShapes(isCrept),
                           gradient.constStates(), tangent, hessian.forces());
                for (std::size_t i = 0; i < count; ++i) {
                    for (const bool second : {false, true}) {
                        const bool right = ((i + parity) % 2 == 0) != second;
                        const auto shape = film.shape(isCrept, second, i);
                        numerics::StressState<float> state;
                        const auto P = stress(gradientOf(cellEdges(film.points(), i, second, right,
                                                                   film.edgesX[i], Cells::edgeZ),
                                                         shape),
                                              resistance, state);
                        const auto states = expected.rowOfStates().states[second];
                        states.cosine[i] = state.cosine;
                        states.sine[i] = state.sine;
                        states.turn[i] = state.turn;
                        states.resists[i] = state.resists;
                        expected.put(i, second, right, edgeForces(P, shape, film.area(i)));
                        const auto change =
                            gradientOf(cellEdges(film.points(), i, second, right, 0, 0), shape);
                        expectedHessian.put(i, second, right,
                                            edgeForces(stressDerivative(change, state, tangent),
                                                       shape, film.area(i)));
                    }
                }
                QVERIFY(gradient == expected);
                QVERIFY(hessian == expectedHessian);
            }
        }
    }
}

void RowKernelsTest::stiffnessRow_everyLength_equalsScalarBits() {
    for (std::size_t count = 1; count <= longest; ++count) {
        const Cells film(count);
        for (const bool isCrept : {false, true}) {
            Edges edges(count);
            gradientRow(count, 0, film.points(), film.rowOfShapes(isCrept), resistance,
                        edges.rowOfStates(), edges.forces());
            Row lines[2] = {Row(16 * count), Row(16 * count)};
            stiffnessRow(count, film.rowOfShapes(isCrept), edges.constStates(),
                         {lines[0].data(), count}, {lines[1].data(), count});
            for (std::size_t i = 0; i < count; ++i) {
                for (const bool second : {false, true}) {
                    const auto states = edges.constStates().states[second];
                    const auto stiffness = numerics::edgeStiffness<float>(
                        film.shape(isCrept, second, i),
                        {states.cosine[i], states.sine[i], states.turn[i], states.resists[i]},
                        film.area(i));
                    Row expected, line;
                    for (const auto& m : {stiffness.hh, stiffness.hv, stiffness.vh, stiffness.vv}) {
                        expected.insert(expected.end(), {m.a, m.b, m.c, m.d});
                    }
                    for (std::size_t k = 0; k < 16; ++k) {
                        line.push_back(lines[second][k * count + i]);
                    }
                    QVERIFY(haveSameBits(line, expected));
                }
            }
        }
    }
}

void RowKernelsTest::addForces_everyLength_equalsScalarBits() {
    for (std::size_t cells = 1; cells <= longest; ++cells) {
        const Row edge = randomRow(cells, 1), left = randomRow(cells, 2),
                  right = randomRow(cells, 3);
        for (const float sign : {-1.f, 1.f}) {
            Row out = randomRow(cells + 1, 4), expected = out;
            addForces(cells, sign, edge.data(), left.data(), right.data(), out.data());
            expected[0] += -edge[0] + sign * left[0];
            for (std::size_t i = 1; i < cells; ++i) {
                expected[i] += (edge[i - 1] - edge[i]) + sign * (left[i] + right[i - 1]);
            }
            expected[cells] += edge[cells - 1] + sign * right[cells - 1];
            QVERIFY(haveSameBits(out, expected));
        }
    }
}

// In every third cell, the lower row's first triangle is turned inside out.
void RowKernelsTest::relaxRow_everyLength_equalsScalarBits() {
    for (std::size_t count = 1; count <= longest; ++count) {
        Cells film(count);
        for (std::size_t i = 0; i < count; i += 3) {
            film.x0[i + 1] = film.x0[i] - 2;
        }
        for (const bool isCrept : {false, true}) {
            for (const unsigned parity : {0u, 1u}) {
                for (const bool second : {false, true}) {
                    for (const float keep : {0.f, 0.7f}) {
                        Row lines(4 * count);
                        relaxRow(count, parity, second, film.points(), film.rowOfShapes(isCrept),
                                 keep, {lines.data(), count});
                        for (std::size_t i = 0; i < count; ++i) {
                            const bool right = ((i + parity) % 2 == 0) != second;
                            const auto shape = film.shape(isCrept, second, i);
                            const auto F = gradientOf(cellEdges(film.points(), i, second, right,
                                                                film.edgesX[i], Cells::edgeZ),
                                                      shape);
                            const auto relaxed = numerics::relaxedInverseShape(shape, F, keep);
                            QVERIFY(haveSameBits({lines[i], lines[count + i], lines[2 * count + i],
                                                  lines[3 * count + i]},
                                                 {relaxed.a, relaxed.b, relaxed.c, relaxed.d}));
                        }
                    }
                }
            }
        }
    }
}

void RowKernelsTest::stretchRange_everyLength_equalsScalarBits() {
    for (std::size_t count = 1; count <= longest; ++count) {
        const Cells film(count);
        Row moving[2] = {randomRow(count, 5), randomRow(count, 6)};
        float largest = 0, least = 1;
        for (std::size_t i = 0; i < count; ++i) {
            for (const bool second : {false, true}) {
                const auto e = cellEdges(film.points(), i, second, (i % 2 == 0) != second,
                                         film.edgesX[i], Cells::edgeZ);
                const float inverseX = film.inversesX[i], inverseZ = Cells::inverseZ;
                const float squares = (e.hx * e.hx + e.hz * e.hz) * inverseX * inverseX +
                                      (e.vx * e.vx + e.vz * e.vz) * inverseZ * inverseZ;
                const float area = (e.hx * e.vz - e.vx * e.hz) * inverseX * inverseZ;
                float& moves = moving[second][i];
                moves = moves > 0 ? 1.f : 0.f;
                largest = moves > 0 ? std::max(largest, squares) : largest;
                least = moves > 0 ? std::min(least, area) : least;
            }
        }
        const StretchRange range = stretchRange(count, 0, film.points(),
                                                {moving[0].data(), moving[1].data()}, film.sizes());
        QVERIFY(range.largestSquares == largest);
        QVERIFY(range.leastArea == least);
    }
}

QTEST_GUILESS_MAIN(RowKernelsTest)
#include "RowKernelsTest.moc"

// Compares the film's elastic law in one triangle with its energy.

#include "production/formulas/PlaneStress.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace dipwright::numerics;

namespace {

const double gatheredSlope = gatheredResistance(0.8); // h′ of gathered film

using Matrix = Matrix2<double>;

Matrix rotation(double angle) {
    return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)};
}
Matrix sum(const Matrix& a, const Matrix& b, double factor) {
    return {a.a + factor * b.a, a.b + factor * b.b, a.c + factor * b.c, a.d + factor * b.d};
}
double product(const Matrix& a, const Matrix& b) {
    return a.a * b.a + a.b * b.b + a.c * b.c + a.d * b.d;
}
double distance(const Matrix& a, const Matrix& b) {
    const Matrix difference = sum(a, b, -1);
    return std::sqrt(product(difference, difference));
}
double traceOfStretch(const Matrix& F) {
    return std::hypot(F.a + F.d, F.c - F.b);
}

// W = δ²/2 + G(s). For s > 1.7, G = (s − 2)². For s < 1.5, where film gathers, G is the parabola
// −s²/4. In between, G is a cubic.
double energy(const Matrix& F) {
    const double s = traceOfStretch(F);
    const double squares = (F.a - F.d) * (F.a - F.d) + (F.b + F.c) * (F.b + F.c);
    const double gathered = 0.8 - 1.0 / 240 - s * s / 4;
    const double within = std::max(s - 1.5, 0.0);
    return squares / 2 +
           (s > 1.7 ? (s - 2) * (s - 2) : gathered + 6.25 / 3 * within * within * within);
}

Matrix stressAt(const Matrix& F) {
    StressState<double> state;
    return stress(F, gatheredSlope, state);
}
Matrix derivativeAt(const Matrix& F, const Matrix& change, Tangent tangent) {
    StressState<double> state;
    stress(F, gatheredSlope, state);
    return stressDerivative(change, state, tangent);
}

const std::vector<Matrix> directions{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

// Returns film that is stretched, sheared, rotated, compressed, about to gather, gathered, and
// inside out.
std::vector<Matrix> states() {
    return {{1.2, 0, 0, 1.1},
            {1.3, 0.4, -0.1, 0.9},
            rotation(2.1) * Matrix{1.1, 0.2, 0.2, 1.4},
            {0.95, 0.02, 0, 0.9},
            {0.9, 0.1, -0.05, 0.66},
            {0.7, 0, 0.1, 0.85},
            {0.6, 0.1, 0, 0.7},
            rotation(-1) * Matrix{0.4, 0, 0.1, 0.5},
            {-1.1, 0.2, 0.3, 1.4}};
}

} // namespace

class PlaneStressTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stress_isTheEnergysGradient();
    void stressDerivative_true_isTheHessian();
    void stressDerivative_projectedInTension_isTheTrueDerivative();
    void stressDerivative_projected_isSemiDefinite();
    void stress_rotatedFilm_isZero();
    void stress_isIsotropic();
    void stress_pulledFilm_narrowsByPoissonsRatio();
    void stress_startOfGathering_isContinuous();
    void relaxedInverseShape_keepsItsShareOfTheStretch();
    void relaxedInverseShape_insideOutFilm_isUnchanged();
};

void PlaneStressTest::stress_isTheEnergysGradient() {
    const double h = 1e-6;
    for (const Matrix& F : states()) {
        for (const Matrix& way : directions) {
            const double slope = (energy(sum(F, way, h)) - energy(sum(F, way, -h))) / (2 * h);
            QVERIFY(std::abs(slope - product(stressAt(F), way)) < 1e-8);
        }
    }
}

void PlaneStressTest::stressDerivative_true_isTheHessian() {
    const double h = 1e-6;
    for (const Matrix& F : states()) {
        for (const Matrix& way : directions) {
            const Matrix ahead = stressAt(sum(F, way, h)), behind = stressAt(sum(F, way, -h));
            QVERIFY(distance(derivativeAt(F, way, Tangent::True),
                             sum({}, sum(ahead, behind, -1), 1 / (2 * h))) < 1e-7);
        }
    }
}

void PlaneStressTest::stressDerivative_projectedInTension_isTheTrueDerivative() {
    for (const Matrix& F : states()) {
        for (const Matrix& way : directions) {
            const double apart = distance(derivativeAt(F, way, Tangent::True),
                                          derivativeAt(F, way, Tangent::Projected));
            QVERIFY(apart == 0 || traceOfStretch(F) < 2);
        }
    }
}

void PlaneStressTest::stressDerivative_projected_isSemiDefinite() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    bool isTrueIndefinite = false;
    for (int i = 0; i < 10000; ++i) {
        const Matrix F{number(random), number(random), number(random), number(random)};
        const Matrix change{number(random), number(random), number(random), number(random)};
        QVERIFY(product(derivativeAt(F, change, Tangent::Projected), change) > -1e-9);
        isTrueIndefinite =
            isTrueIndefinite || product(derivativeAt(F, change, Tangent::True), change) < -0.1;
    }
    QVERIFY(isTrueIndefinite);
}

void PlaneStressTest::stress_rotatedFilm_isZero() {
    for (const double angle : {0.0, 0.3, 1.5, -3.0}) {
        QVERIFY(distance(stressAt(rotation(angle)), {}) < 1e-11);
    }
}

void PlaneStressTest::stress_isIsotropic() {
    for (const Matrix& F : states()) {
        for (const double angle : {0.4, 2.0}) {
            const Matrix Q = rotation(angle);
            QVERIFY(distance(stressAt(Q * F), Q * stressAt(F)) < 1e-11);
            QVERIFY(distance(stressAt(F * Q), stressAt(F) * Q) < 1e-11);
        }
    }
}

// Poisson's ratio is 1/3: film stretched along X by e narrows by e/3 without stress along Z.
// Young's modulus is 8/3.
void PlaneStressTest::stress_pulledFilm_narrowsByPoissonsRatio() {
    for (const double e : {0.001, 0.1, 0.5}) {
        const Matrix P = stressAt({1 + e, 0, 0, 1 - e / 3});
        QVERIFY(std::abs(P.d) < 1e-11);
        QVERIFY(std::abs(P.a - 8 * e / 3) < 1e-11);
    }
}

// The stress and its derivative are continuous at both ends of the transition to gathered film.
// Outside the transition, exactly one of the two laws applies.
void PlaneStressTest::stress_startOfGathering_isContinuous() {
    const auto squeezed = [](double s) { return stressAt({s / 2, 0, 0, s / 2}).a; };
    const auto resistance = [](double s) {
        StressState<double> state;
        stress(Matrix{s / 2, 0, 0, s / 2}, gatheredSlope, state);
        return state.resists;
    };
    const double begin = 1.6 + gatheringWidth, end = 1.6 - gatheringWidth;
    for (const double s : {begin, 1.6, end}) {
        QVERIFY(std::abs(squeezed(s + 1e-9) - squeezed(s - 1e-9)) < 1e-8);
        QVERIFY(std::abs(resistance(s + 1e-9) - resistance(s - 1e-9)) < 1e-7);
    }
    QVERIFY(std::abs(squeezed(begin) - 2 * (begin - 2)) < 1e-11);
    QVERIFY(std::abs(squeezed(end) + end / 2) < 1e-11);
    QCOMPARE(resistance(begin + 0.01), 1.0);
    QCOMPARE(resistance(end - 0.01), gatheredSlope);
    // Beyond the transition, film resists less the more it is gathered.
    QVERIFY(std::abs(squeezed(1.0)) < std::abs(squeezed(end)));
}

// D is the matrix of the rest edges. Relaxation changes D to D′, but leaves the edges E = F·D. So
// the gradient is then E·D′⁻¹.
void PlaneStressTest::relaxedInverseShape_keepsItsShareOfTheStretch() {
    const Matrix inverseShape{2, 0.1, -0.2, 1.5};
    const Matrix F = rotation(0.7) * Matrix{1.3, 0.1, 0.1, 0.9};
    const Matrix edges = F * inverse(inverseShape);
    const auto after = [&](double keep) {
        return edges * relaxedInverseShape(inverseShape, F, keep);
    };
    QVERIFY(distance(after(1), F) < 1e-12);
    QVERIFY(distance(stressAt(after(0)), {}) < 1e-11);
    const Matrix half = rotation(0.7) * Matrix{1.15, 0.05, 0.05, 0.95};
    QVERIFY(distance(after(0.5), half) < 1e-12);
}

void PlaneStressTest::relaxedInverseShape_insideOutFilm_isUnchanged() {
    const Matrix shape{2, 0, 0, 2};
    QVERIFY(distance(relaxedInverseShape(shape, Matrix{-1, 0, 0, 1}, 0.0), shape) == 0);
}

QTEST_GUILESS_MAIN(PlaneStressTest)
#include "PlaneStressTest.moc"

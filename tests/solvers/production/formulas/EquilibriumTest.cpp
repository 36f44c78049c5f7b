// Tests the search for equilibrium with the smallest backend possible: one spring instead of a
// film. Tests its linear solver with a matrix in place of the film.

#include "production/formulas/Equilibrium.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

using namespace dipwright::numerics;

namespace {

// One free point on a spring with the force pull(x).
struct Spring {
    using Real = double;
    std::function<double(double)> pull;
    std::function<double(double)> slope;
    double x = 0;
    int forcesTaken = 0, linearSolves = 0;

    FilmModel<double> model() const {
        FilmModel<double> film;
        film.columns = film.rows = 1;
        film.spacingX = film.spacingZ = 10;
        film.residual = 1e-6;
        return film;
    }
    static constexpr NewtonLimits newtonLimits() { return {}; }
    StepState<double>& state() { return state_; }
    void setFree() {}
    FilmForce force(double) {
        ++forcesTaken;
        return {std::abs(pull(x)), 1};
    }
    FilmForce forceAlong(double length, double drag) {
        x = start_ + length * step_;
        return force(drag);
    }
    Vector2<double> forceOn(int) const { return {pull(x), 0}; }
    void prepareLinear(double) {}
    void solveLinear(double drag, Tangent, double, double) {
        ++linearSolves;
        step_ = -pull(x) / (slope(x) + drag);
    }
    double startOfStep() {
        start_ = x;
        return std::abs(step_);
    }
    void keepBest() { best_ = x; }
    void takeBest() { x = best_; }

private:
    StepState<double> state_;
    double start_ = 0, step_ = 0, best_ = 0;
};
static_assert(FilmEquilibrium<Spring>);

Spring spring(double x, std::function<double(double)> pull, std::function<double(double)> slope) {
    Spring film;
    film.pull = std::move(pull);
    film.slope = std::move(slope);
    film.x = x;
    return film;
}

// A system of `size` equations. The entries on the diagonal are at least `diagonal`; the other
// entries are random, unsymmetric numbers up to 1. Smoothing divides by the diagonal.
struct Matrix {
    using Real = double;
    using Vector = std::vector<double>;

    Matrix(std::size_t size, double diagonal) : entries(size, Vector(size)), forces(size) {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(-1, 1);
        for (std::size_t i = 0; i < size; ++i) {
            std::ranges::generate(entries[i], [&] { return number(random); });
            entries[i][i] = diagonal + double(i % 3);
            forces[i] = number(random);
        }
        basis.resize(std::size_t(mostBasisVectors) + 1);
        smoothed.resize(std::size_t(mostBasisVectors));
    }

    static double dot(const Vector& a, const Vector& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    }
    static void add(double factor, const Vector& a, Vector& out) {
        std::ranges::transform(out, a, out.begin(),
                               [&](double was, double more) { return was + factor * more; });
    }
    Vector times(const Vector& v, double drag) const {
        Vector product;
        for (std::size_t i = 0; i < v.size(); ++i) {
            product.push_back(dot(entries[i], v) + drag * v[i]);
        }
        return product;
    }
    double left(double drag) const {
        Vector sum = times(step, drag);
        add(1, forces, sum);
        return std::sqrt(dot(sum, sum));
    }

    StepState<double>& state() { return state_; }
    template <typename Work>
    double inSmallProblem(const Work& work) {
        return work(problem);
    }
    void startBasis(double factor) {
        basis[0].assign(forces.size(), 0);
        add(factor, forces, basis[0]);
    }
    void extendBasis(int count, double drag, Tangent) {
        const auto newest = std::size_t(count);
        smoothed[newest] = basis[newest];
        for (std::size_t i = 0; i < forces.size(); ++i) {
            smoothed[newest][i] /= entries[i][i];
        }
        Vector next = times(smoothed[newest], drag);
        for (std::size_t i = 0; i <= newest; ++i) {
            problem.matrix[count][i] = dot(next, basis[i]);
            add(-problem.matrix[count][i], basis[i], next);
        }
        const double size = count == brokenColumn ? std::numeric_limits<double>::quiet_NaN()
                                                  : std::sqrt(dot(next, next));
        problem.matrix[count][count + 1] = size;
        std::ranges::transform(next, next.begin(), [&](double v) { return v / size; });
        basis[newest + 1] = next;
    }
    void setStep(int count) {
        step.assign(forces.size(), 0);
        for (int i = 0; i < count; ++i) {
            add(-problem.weights[i], smoothed[std::size_t(i)], step);
        }
    }

    std::vector<Vector> entries, basis, smoothed;
    Vector forces, step;
    int brokenColumn = -1; // this column has a length that is not a number; -1: none has
    GmresProblem problem;

private:
    StepState<double> state_;
};
static_assert(GmresBackend<Matrix>);

} // namespace

class EquilibriumTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void findEquilibrium_filmAtRest_doesNotMove();
    void findEquilibrium_spring_reachesTheRoot();
    void findEquilibrium_tooLongSteps_areShortened();
    void findEquilibrium_step_isAtMostTwoCells();
    void findEquilibrium_noRoot_endsAtTheSmallestForce();
    void findEquilibrium_nanStep_stops();
    void findEquilibrium_uphillStep_isTurnedDownhill();
    void findEquilibrium_farFromRest_acceptsRounding();
    void findEquilibrium_result_hasResidualAndConvergence();
    void solveGmres_unsymmetricSystem_isSolved();
    void solveGmres_manyEquations_reducesTheResidual();
    void solveGmres_smallSystem_isExact();
    void solveGmres_noForces_takesNoStep();
    void solveGmres_columnWithoutNumbers_isLeftOut();
};

void EquilibriumTest::findEquilibrium_filmAtRest_doesNotMove() {
    Spring film = spring(
        3, [](double x) { return x - 3; }, [](double) { return 1.0; });
    findEquilibrium(film, 0, 0);
    QCOMPARE(film.x, 3.0);
    QCOMPARE(film.linearSolves, 0);
}

void EquilibriumTest::findEquilibrium_spring_reachesTheRoot() {
    Spring film = spring(
        4, [](double x) { return x * x * x - 8; }, [](double x) { return 3 * x * x; });
    findEquilibrium(film, 0, 0);
    QVERIFY(std::abs(film.pull(film.x)) <= 1e-6);
    QVERIFY(std::abs(film.x - 2) < 1e-6);
}

// Without a line search, Newton's method diverges from the root of arctan if it begins beyond 1.39.
void EquilibriumTest::findEquilibrium_tooLongSteps_areShortened() {
    Spring film = spring(
        3, [](double x) { return std::atan(x); }, [](double x) { return 1 / (1 + x * x); });
    findEquilibrium(film, 0, 0);
    QVERIFY(std::abs(film.x) < 1e-6);
    QVERIFY(film.forcesTaken > film.linearSolves + 1);
}

void EquilibriumTest::findEquilibrium_step_isAtMostTwoCells() {
    double farthest = 0, last = 0;
    Spring film = spring(
        0,
        [&](double x) {
            farthest = std::max(farthest, std::abs(x - last));
            last = x;
            return x - 90;
        },
        [](double) { return 1.0; });
    findEquilibrium(film, 0, 0);
    QVERIFY(std::abs(film.x - 90) < 1e-6);
    QVERIFY(farthest <= longestNewtonStep * 10 + 1e-9);
}

// Without a root, the film ends where the forces were least, not where the search stopped.
void EquilibriumTest::findEquilibrium_noRoot_endsAtTheSmallestForce() {
    double last = 0;
    Spring film = spring(
        0.7,
        [&](double x) {
            last = x;
            return x * x + 1;
        },
        [](double x) { return 2 * x; });
    QVERIFY(!findEquilibrium(film, 0, 0).isReached);
    QVERIFY(film.x != last);
    QVERIFY(film.pull(film.x) < 1.001);
}

void EquilibriumTest::findEquilibrium_nanStep_stops() {
    Spring film = spring(
        1, [](double x) { return x - 5; },
        [](double) { return std::numeric_limits<double>::quiet_NaN(); });
    QVERIFY(!findEquilibrium(film, 0, 0).isReached);
    QCOMPARE(film.x, 1.0);
}

// With a negative stiffness, the step leads uphill. A stiffer film makes the step lead downhill.
void EquilibriumTest::findEquilibrium_uphillStep_isTurnedDownhill() {
    Spring film = spring(
        4, [](double x) { return x - 3; }, [](double) { return -1.0; });
    QVERIFY(findEquilibrium(film, 0, 0).isReached);
    QVERIFY(std::abs(film.x - 3) < 1e-6);
}

// The remaining forces are only rounding errors. They arise because the positions are far from
// rest.
void EquilibriumTest::findEquilibrium_farFromRest_acceptsRounding() {
    const double rounding = NewtonLimits().flatForce * 100;
    Spring film = spring(
        100, [&](double x) { return x < 100 ? 1 : rounding; }, [](double) { return 1.0; });
    QVERIFY(!findEquilibrium(film, 0, 0).isReached);
    film.linearSolves = 0;
    film.x = 100;
    QVERIFY(findEquilibrium(film, 0, 100).isReached);
    QCOMPARE(film.linearSolves, 0);
}

void EquilibriumTest::findEquilibrium_result_hasResidualAndConvergence() {
    Spring rests = spring(
        4, [](double x) { return x - 3; }, [](double) { return 1.0; });
    const EquilibriumResult found = findEquilibrium(rests, 0, 0);
    QVERIFY(found.isReached);
    QVERIFY(found.left <= 1e-6);
    QCOMPARE(rests.linearSolves, 1);
    Spring none = spring(
        0, [](double x) { return std::hypot(x, 0.5); },
        [](double x) { return x / std::hypot(x, 0.5); });
    const EquilibriumResult missed = findEquilibrium(none, 0, 0);
    QVERIFY(!missed.isReached);
    QVERIFY(std::abs(missed.left - 0.5) < 1e-6); // the elastic forces are 1
}

void EquilibriumTest::solveGmres_unsymmetricSystem_isSolved() {
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
        Matrix film(10, 4);
        solveGmres(film, 0.3, Tangent::True, std::sqrt(Matrix::dot(film.forces, film.forces)),
                   tolerance);
        QVERIFY(film.left(0.3) <= tolerance * 1.001);
    }
}

// There are more equations than basis vectors.
void EquilibriumTest::solveGmres_manyEquations_reducesTheResidual() {
    Matrix film(40, 12); // well conditioned
    const double start = std::sqrt(Matrix::dot(film.forces, film.forces));
    solveGmres(film, 0, Tangent::True, start, 1e-4 * start);
    QVERIFY(film.state().equilibrium.linearIterations <= mostBasisVectors);
    QVERIFY(film.left(0) <= 1.001e-4 * start);
    Matrix never(40, 0.5);
    solveGmres(never, 0, Tangent::True, start, 0);
    QCOMPARE(never.state().equilibrium.linearIterations, std::int64_t(mostBasisVectors));
    QVERIFY(never.left(0) < start);
}

// With as many vectors as equations, the residual is zero.
void EquilibriumTest::solveGmres_smallSystem_isExact() {
    Matrix film(5, 0.5);
    solveGmres(film, 0, Tangent::True, std::sqrt(Matrix::dot(film.forces, film.forces)), 1e-9);
    QCOMPARE(film.state().equilibrium.linearIterations, std::int64_t(5));
    QVERIFY(film.left(0) < 1e-9);
}

void EquilibriumTest::solveGmres_noForces_takesNoStep() {
    Matrix film(5, 4);
    film.forces.assign(5, 0);
    solveGmres(film, 0, Tangent::True, 0, 0);
    QCOMPARE(film.state().equilibrium.linearIterations, std::int64_t(0));
    QCOMPARE(film.step, Matrix::Vector(5, 0));
}

// The second column, or the first, has no numbers. The step is that of the columns before.
void EquilibriumTest::solveGmres_columnWithoutNumbers_isLeftOut() {
    for (const int broken : {1, 0}) {
        Matrix film(5, 4);
        film.brokenColumn = broken;
        const double start = std::sqrt(Matrix::dot(film.forces, film.forces));
        solveGmres(film, 0, Tangent::True, start, 1e-9);
        QCOMPARE(film.state().equilibrium.linearIterations, std::int64_t(broken + 1));
        QVERIFY(broken == 0 ? film.left(0) == start : film.left(0) < start);
    }
}

QTEST_GUILESS_MAIN(EquilibriumTest)
#include "EquilibriumTest.moc"

// The search for equilibrium, with the film stood in for by one spring: the smallest backend.

#include "production/formulas/Equilibrium.h"

#include <QTest>
#include <cmath>
#include <functional>
#include <limits>

using namespace dipwright::numerics;

namespace {

// One free point on a spring of force(x), with a linear solver as good as `solverError` makes it.
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
    void setFree() {}
    FilmForce force(double) {
        ++forcesTaken;
        return {std::abs(pull(x)), 1};
    }
    FilmForce forceAlong(double length, double drag) {
        x = start_ + length * step_;
        return force(drag);
    }
    void solveLinear(double, double, double) {
        ++linearSolves;
        step_ = -pull(x) / slope(x);
    }
    double startOfStep() {
        start_ = x;
        return std::abs(step_);
    }
    void keepBest() { best_ = x; }
    void takeBest() { x = best_; }

private:
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

} // namespace

class EquilibriumTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void filmAtRestIsLeftAlone();
    void findsTheEquilibrium();
    void shortensStepsThatGoTooFar();
    void movesNoPointFartherThanTwoCells();
    void endsAtTheLeastForceMet();
    void stopsAtAStepThatIsNoNumber();
};

void EquilibriumTest::filmAtRestIsLeftAlone() {
    Spring film = spring(
        3, [](double x) { return x - 3; }, [](double) { return 1.0; });
    findEquilibrium(film, 0);
    QCOMPARE(film.x, 3.0);
    QCOMPARE(film.linearSolves, 0);
}

void EquilibriumTest::findsTheEquilibrium() {
    Spring film = spring(
        4, [](double x) { return x * x * x - 8; }, [](double x) { return 3 * x * x; });
    findEquilibrium(film, 0);
    QVERIFY(std::abs(film.pull(film.x)) <= 1e-6);
    QVERIFY(std::abs(film.x - 2) < 1e-6);
}

// Newton's method by itself flees from the root of arctan when it begins past 1.39.
void EquilibriumTest::shortensStepsThatGoTooFar() {
    Spring film = spring(
        3, [](double x) { return std::atan(x); }, [](double x) { return 1 / (1 + x * x); });
    findEquilibrium(film, 0);
    QVERIFY(std::abs(film.x) < 1e-6);
    QVERIFY(film.forcesTaken > film.linearSolves + 1);
}

void EquilibriumTest::movesNoPointFartherThanTwoCells() {
    double farthest = 0, last = 0;
    Spring film = spring(
        0,
        [&](double x) {
            farthest = std::max(farthest, std::abs(x - last));
            last = x;
            return x - 90;
        },
        [](double) { return 1.0; });
    findEquilibrium(film, 0);
    QVERIFY(std::abs(film.x - 90) < 1e-6);
    QVERIFY(farthest <= longestNewtonStep * 10 + 1e-9);
}

// No root: the film ends where the forces were least, not where the search stopped.
void EquilibriumTest::endsAtTheLeastForceMet() {
    double least = std::numeric_limits<double>::infinity(), where = 0;
    Spring film = spring(
        0.7,
        [&](double x) {
            const double force = x * x + 1;
            where = force < least ? x : where;
            least = std::min(least, force);
            return force;
        },
        [](double x) { return 2 * x; });
    findEquilibrium(film, 0);
    QCOMPARE(film.x, where);
    QCOMPARE(film.linearSolves, NewtonLimits().newtonSteps);
}

void EquilibriumTest::stopsAtAStepThatIsNoNumber() {
    Spring film = spring(
        1, [](double x) { return x - 5; },
        [](double) { return std::numeric_limits<double>::quiet_NaN(); });
    findEquilibrium(film, 0);
    QCOMPARE(film.x, 1.0);
    QCOMPARE(film.linearSolves, 1);
}

QTEST_GUILESS_MAIN(EquilibriumTest)
#include "EquilibriumTest.moc"

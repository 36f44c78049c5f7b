// The parts of the multigrid cycle for the film's stiffness: its smoother and its grids.

#include "production/formulas/GalerkinCycle.h"

#include <QTest>
#include <cmath>

using namespace dipwright::numerics::galerkin;

class GalerkinCycleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void smoothingSteps_dampTheirPartOfTheSpectrum();
    void coarser_repeated_reachesTheCoarsestGrid();
    void coarser_grid_coversTheFineOne();
};

// An error in an eigenvector of eigenvalue λ has a residual of λ times the error.
void GalerkinCycleTest::smoothingSteps_dampTheirPartOfTheSpectrum() {
    const auto left = [](const auto& steps, double eigenvalue) {
        double error = 1, direction = 0;
        for (const ChebyshevStep& step : steps) {
            direction = double(step.keep) * direction - double(step.gain) * eigenvalue * error;
            error += direction;
        }
        return std::abs(error);
    };
    for (double eigenvalue = smallestSmoothed; eigenvalue < largestEigenvalue; eigenvalue += 0.01) {
        QVERIFY(left(smoothingSteps, eigenvalue) < 0.4);
        QVERIFY(left(coarsestSteps, eigenvalue) < 1e-4);
    }
    for (double eigenvalue = 0; eigenvalue < smallestSmoothed; eigenvalue += 0.01) {
        QVERIFY(left(smoothingSteps, eigenvalue) <= 1); // errors that are not smoothed do not grow
        QVERIFY(left(coarsestSteps, eigenvalue) <= 1);
    }
}

void GalerkinCycleTest::coarser_repeated_reachesTheCoarsestGrid() {
    for (int columns : {2, 5, 6, 33, 120, 2000}) {
        int rows = 3 * columns / 2, levels = 1;
        while (!isCoarsest(columns, rows)) {
            columns = coarser(columns);
            rows = coarser(rows);
            QVERIFY(columns >= 3 && ++levels < 20);
        }
    }
}

// The coarse points lie on the fine points 0, 2, 4 … They reach the last one or pass it by less
// than a coarse cell.
void GalerkinCycleTest::coarser_grid_coversTheFineOne() {
    for (int points = 2; points < 100; ++points) {
        const int last = 2 * (coarser(points) - 1);
        QVERIFY(last >= points - 1 && last <= points);
    }
}

QTEST_GUILESS_MAIN(GalerkinCycleTest)
#include "GalerkinCycleTest.moc"

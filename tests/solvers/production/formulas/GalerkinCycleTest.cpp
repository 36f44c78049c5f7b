// Tests the parts of the multigrid cycle for the film's stiffness: the smoother and the grids.

#include "production/formulas/GalerkinCycle.h"

#include <QTest>
#include <cmath>

using namespace dipwright::numerics::galerkin;

class GalerkinCycleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void smoothingSteps_errorsInTheirSpectrum_areDamped();
    void coarser_repeated_reachesTheCoarsestGrid();
    void coarser_grid_coversTheFineGrid();
};

// The residual of an error that is an eigenvector with the eigenvalue λ is λ times the error.
void GalerkinCycleTest::smoothingSteps_errorsInTheirSpectrum_areDamped() {
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

// The coarse points lie on the fine points 0, 2, 4 … The last coarse point lies on the last fine
// point, or less than a coarse cell past it.
void GalerkinCycleTest::coarser_grid_coversTheFineGrid() {
    for (int points = 2; points < 100; ++points) {
        const int last = 2 * (coarser(points) - 1);
        QVERIFY(last >= points - 1 && last <= points);
    }
}

QTEST_GUILESS_MAIN(GalerkinCycleTest)
#include "GalerkinCycleTest.moc"

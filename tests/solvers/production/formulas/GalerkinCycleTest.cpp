// What the multigrid cycle for the film's stiffness consists of: its smoother and its grids.

#include "production/formulas/GalerkinCycle.h"

#include <QTest>
#include <cmath>

using namespace dipwright::numerics::galerkin;

class GalerkinCycleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void smoothingDampsItsPartOfTheSpectrum();
    void gridsShrinkToTheCoarsest();
    void everyPointLiesBetweenCoarseOnes();
};

// Of an error in an eigenvector of eigenvalue λ, which the residual is λ times.
void GalerkinCycleTest::smoothingDampsItsPartOfTheSpectrum() {
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
        QVERIFY(left(smoothingSteps, eigenvalue) <= 1); // what is not smoothed does not grow
        QVERIFY(left(coarsestSteps, eigenvalue) <= 1);
    }
}

void GalerkinCycleTest::gridsShrinkToTheCoarsest() {
    for (int columns : {2, 5, 6, 33, 120, 2000}) {
        int rows = 3 * columns / 2, levels = 1;
        while (!isCoarsest(columns, rows)) {
            columns = coarser(columns);
            rows = coarser(rows);
            QVERIFY(columns >= 3 && ++levels < 20);
        }
    }
}

// The coarse points on fine ones 0, 2, 4 … reach to the last one or past it, but not a whole cell.
void GalerkinCycleTest::everyPointLiesBetweenCoarseOnes() {
    for (int points = 2; points < 100; ++points) {
        const int last = 2 * (coarser(points) - 1);
        QVERIFY(last >= points - 1 && last <= points);
    }
}

QTEST_GUILESS_MAIN(GalerkinCycleTest)
#include "GalerkinCycleTest.moc"

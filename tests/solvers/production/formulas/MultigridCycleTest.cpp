// What the multigrid cycle consists of: its stencil, its smoother and its grids.

#include "production/formulas/MultigridCycle.h"

#include <QTest>
#include <cmath>

using namespace dipwright::numerics::multigrid;

class MultigridCycleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stiffnessIsSymmetricAndFreeOfForceAtRest();
    void stencilIsTheStiffnessOfFourCells();
    void smoothingDampsItsPartOfTheSpectrum();
    void interpolationIsExactForLinear();
    void gridsShrinkToTheCoarsest();
};

void MultigridCycleTest::stiffnessIsSymmetricAndFreeOfForceAtRest() {
    const double hx = 1.2, hz = 0.8;
    const CellStiffness K = cellStiffness(hx, hz);
    const double xs[] = {0, hx, 0, hx}, zs[] = {0, 0, hz, hz};
    for (std::size_t m = 0; m < 8; ++m) {
        double moved = 0, turned = 0;
        for (std::size_t n = 0; n < 8; ++n) {
            QCOMPARE(K[m][n], K[n][m]);
            moved += n % 2 == 0 ? double(K[m][n]) : 0;
            turned += double(K[m][n]) * (n % 2 == 0 ? -zs[n / 2] : xs[n / 2]);
        }
        QVERIFY(std::abs(moved) < 1e-5);
        QVERIFY(std::abs(turned) < 1e-5);
    }
}

void MultigridCycleTest::stencilIsTheStiffnessOfFourCells() {
    const double hx = 1.2, hz = 0.8;
    const CellStiffness K = cellStiffness(hx, hz);
    const Stencil weights = stencil(hx, hz);
    // Of a point on its neighbour to the right: two cells have both, as their lower and upper pair.
    QVERIFY(std::abs(double(K[0][2] + K[4][6]) + double(weights.xx)) < 1e-5);
    QVERIFY(std::abs(double(K[1][3] + K[5][7]) + double(weights.zx)) < 1e-5);
    QVERIFY(std::abs(double(K[0][4] + K[2][6]) + double(weights.xz)) < 1e-5);
    QVERIFY(std::abs(double(K[1][5] + K[3][7]) + double(weights.zz)) < 1e-5);
    QVERIFY(std::abs(4 * double(K[0][0]) - 2 * double(weights.xx + weights.xz)) < 1e-5);
}

// Of an error in an eigenvector of eigenvalue λ, which the residual is λ times.
void MultigridCycleTest::smoothingDampsItsPartOfTheSpectrum() {
    const auto left = [](int degree, double eigenvalue) {
        double error = 1, direction = 0;
        for (const ChebyshevStep& step : chebyshev(degree)) {
            direction = double(step.keep) * direction - double(step.gain) * eigenvalue * error;
            error += direction;
        }
        return std::abs(error);
    };
    QCOMPARE(int(chebyshev(smoothingDegree).size()), smoothingDegree);
    for (double eigenvalue = smallestSmoothed; eigenvalue < largestEigenvalue; eigenvalue += 0.01) {
        QVERIFY(left(smoothingDegree, eigenvalue) < 0.3);
        QVERIFY(left(coarsestDegree, eigenvalue) < 1e-5);
    }
    for (double eigenvalue = 0; eigenvalue < smallestSmoothed; eigenvalue += 0.01) {
        QVERIFY(left(smoothingDegree, eigenvalue) <= 1); // what is not smoothed does not grow
    }
}

void MultigridCycleTest::interpolationIsExactForLinear() {
    for (const int fine : {7, 12, 120, 171}) {
        const int coarse = coarser(fine);
        const Interpolation axis = interpolation(fine, coarse);
        QCOMPARE(int(axis.first.size()), fine);
        for (int i = 0; i < fine; ++i) {
            const auto k = std::size_t(i);
            QVERIFY(axis.first[k] >= 0 && axis.first[k] + 1 < coarse);
            QVERIFY(axis.weight[k] >= 0 && axis.weight[k] <= 1);
            const double place = (axis.first[k] + double(axis.weight[k])) / (coarse - 1);
            QVERIFY(std::abs(place - double(i) / (fine - 1)) < 1e-6);
        }
    }
}

void MultigridCycleTest::gridsShrinkToTheCoarsest() {
    for (int columns : {5, 33, 120, 2000}) {
        int rows = 3 * columns / 2, levels = 1;
        while (!isCoarsest(columns, rows)) {
            columns = coarser(columns);
            rows = coarser(rows);
            QVERIFY(columns >= 3 && ++levels < 20);
        }
    }
}

QTEST_GUILESS_MAIN(MultigridCycleTest)
#include "MultigridCycleTest.moc"

// Tests random draws of handling errors, whose mean and covariance must be exact.
#include "accuracy/tolerance/Draws.h"

#include <QtTest>

using namespace dipwright;

class DrawsTest : public QObject {
    Q_OBJECT

private slots:
    void evenDraws_haveZeroMeanAndUnitCovariance() {
        const Eigen::MatrixXd draws = evenDraws(24, 12, 1);
        QCOMPARE(draws.rows(), Eigen::Index(24));
        QVERIFY(draws.colwise().mean().cwiseAbs().maxCoeff() < 1e-12);
        const Eigen::MatrixXd covariance = draws.transpose() * draws / 24;
        QVERIFY((covariance - Eigen::MatrixXd::Identity(12, 12)).cwiseAbs().maxCoeff() < 1e-9);
    }

    void evenDraws_fewAsked_givesTwoForEachQuantity() {
        QCOMPARE(evenDraws(3, 8, 1).rows(), Eigen::Index(16));
        QCOMPARE(evenDraws(25, 8, 1).rows(), Eigen::Index(26));
    }

    void evenDraws_seed_determinesTheDraws() {
        QVERIFY(evenDraws(24, 5, 7) == evenDraws(24, 5, 7));
        QVERIFY(evenDraws(24, 5, 7) != evenDraws(24, 5, 8));
    }

    void evenDraws_many_areNormallyDistributed() {
        const Eigen::MatrixXd draws = evenDraws(2000, 1, 3);
        const double within = double((draws.array().abs() < 1).count()) / 2000;
        QVERIFY2(std::abs(within - 0.683) < 0.03,
                 qPrintable(
                     QStringLiteral("share within one deviation %1, expected 0.683").arg(within)));
    }
};

QTEST_APPLESS_MAIN(DrawsTest)
#include "DrawsTest.moc"

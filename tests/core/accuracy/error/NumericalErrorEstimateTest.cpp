// The coarser dips with which the numerical error of a sheet is estimated.
#include "accuracy/error/NumericalErrorEstimate.h"

#include "DippedByHand.h"
#include "film/FilmGrid.h"
#include "geometry/FinerFields.h"
#include "geometry/Shapes.h"

#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

class NumericalErrorEstimateTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    // Otherwise the estimate would not show the error of the field.
    void coarserFilms_ofFineFilm_haveAFieldOfTwiceTheCells() {
        const TriangleMesh mesh = boxMesh({60, 30, 50});
        const auto field = cachedDistanceField(mesh, 64, {});
        const auto body = std::make_shared<const PosedBody>(test::posed(mesh));
        FilmSettings film;
        film.columns = 160;
        film.rows = 160;
        const double cell = filmGrid(film).leastSpacing();
        const int level = fieldLevel(*field, cell);
        QVERIFY(level > 0);
        const CoarserDips dips({body, {}}, *field, film, {}, {});
        QCOMPARE(dips.items().size(), std::size_t(2));
        for (const solver::BatchItem& item : dips.items()) {
            QCOMPARE(item.setup.field.spacing, field->spacing / std::exp2(level - 1));
            QVERIFY(item.setup.film.leastSpacing() > 1.9 * cell);
        }
    }
};

QTEST_GUILESS_MAIN(NumericalErrorEstimateTest)
#include "NumericalErrorEstimateTest.moc"

// The coarser dips with which the numerical error of a sheet is estimated.
#include "accuracy/error/NumericalErrorEstimate.h"

#include "DippedByHand.h"
#include "film/FilmGrid.h"
#include "geometry/FinerFields.h"
#include "geometry/Shapes.h"

#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

// Keeps the setups of a batch, and does not simulate it.
class KeepingModule : public solver::SolverModule {
public:
    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return "none"; }
    std::unique_ptr<solver::FilmSolver> create() const override { return nullptr; }
    bool runBatch(std::span<solver::BatchItem> dips, solver::CancelFunction, void*) const override {
        for (const solver::BatchItem& dip : dips) {
            kept.push_back(dip.setup);
        }
        return false;
    }
    mutable std::vector<solver::DipSetup> kept;
};

} // namespace

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
        const KeepingModule module;
        QVERIFY_THROWS_EXCEPTION(
            Cancelled, coarserFilms({{body, {}}}, *field, film, {}, module, [] { return false; }));
        QCOMPARE(module.kept.size(), std::size_t(2));
        for (const solver::DipSetup& setup : module.kept) {
            QCOMPARE(setup.field.spacing, field->spacing / std::exp2(level - 1));
            QVERIFY(setup.film.leastSpacing() > 1.9 * cell);
        }
    }
};

QTEST_GUILESS_MAIN(NumericalErrorEstimateTest)
#include "NumericalErrorEstimateTest.moc"

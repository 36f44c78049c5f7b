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

// Keeps the setups of a batch. Simulating it fails, or is cancelled.
class NoSolver : public solver::SolverModule {
public:
    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return "none"; }
    std::unique_ptr<solver::FilmSolver> create() const override { return nullptr; }
    bool runBatch(std::span<solver::BatchItem> dips, solver::CancelFunction, void*) const override {
        for (const solver::BatchItem& dip : dips) {
            setups.push_back(dip.setup);
        }
        if (fails) {
            throw std::runtime_error("out of order");
        }
        return false;
    }
    mutable std::vector<solver::DipSetup> setups;
    bool fails = false;
};

FilmSettings fineFilm() {
    FilmSettings film;
    film.columns = 160;
    film.rows = 160;
    return film;
}

} // namespace

class NumericalErrorEstimateTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        const TriangleMesh mesh = boxMesh({60, 30, 50});
        body_ = std::make_shared<const PosedBody>(test::posed(mesh));
        field_ = cachedDistanceField(mesh, 64, {});
    }

    // Otherwise the estimate would not show the error of the field.
    void coarserDips_ofFineFilm_haveAFieldOfTwiceTheCells() {
        const double cell = filmGrid(fineFilm()).leastSpacing();
        const int level = fieldLevel(*field_, cell);
        QVERIFY(level > 0);
        const NoSolver module;
        CoarserDips dips({body_, {}}, *field_, fineFilm(), {}, {});
        QVERIFY_THROWS_EXCEPTION(Cancelled,
                                 CoarserDips::simulate({&dips}, module, [] { return false; }));
        QCOMPARE(module.setups.size(), std::size_t(2));
        for (const solver::DipSetup& setup : module.setups) {
            QCOMPARE(setup.field.spacing, field_->spacing / std::exp2(level - 1));
            QVERIFY(setup.film.leastSpacing() > 1.9 * cell);
        }
    }

    void coarserDips_solverFails_onlyTheComparisonFails() {
        NoSolver module;
        module.fails = true;
        CoarserDips one({body_, {}}, *field_, fineFilm(), {}, {});
        FilmSettings tiny = fineFilm();
        tiny.columns = tiny.rows = 6;
        CoarserDips other({body_, {}}, *field_, tiny, {}, {});
        CoarserDips::simulate({&one, &other}, module, [] { return false; });
        QCOMPARE(module.setups.size(), std::size_t(2));
        QVERIFY(one.laid().failure.contains(QStringLiteral("out of order")));
        QVERIFY(other.laid().failure.contains(QStringLiteral("too few points")));
    }

private:
    std::shared_ptr<const PosedBody> body_;
    std::shared_ptr<const DistanceField> field_;
};

QTEST_GUILESS_MAIN(NumericalErrorEstimateTest)
#include "NumericalErrorEstimateTest.moc"

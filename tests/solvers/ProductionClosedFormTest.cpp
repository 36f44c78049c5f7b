// Compares the production film on the CPU with its closed forms.
#include "WholeSample.h"
#include "production/cpu/ProductionFilm.h"
#include "validation/PhysicsValidation.h"

#include <QTest>
#include <cmath>

using namespace dipwright;

namespace {

// A solver module with the CPU's production film.
class FilmModule : public solver::SolverModule {
public:
    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return "test"; }
    std::unique_ptr<solver::FilmSolver> create() const override {
        return cpu::makeProductionFilm();
    }
    bool runBatch(std::span<solver::BatchItem>, solver::CancelFunction, void*) const override {
        return false;
    }
};

} // namespace

class ProductionClosedFormTest : public QObject {
    Q_OBJECT

private slots:
    void productionFilm_dips_matchTheClosedForms();
};

void ProductionClosedFormTest::productionFilm_dips_matchTheClosedForms() {
    PhysicsOptions options;
    options.resolutions = {15, 30};
    if (!test::isWholeRun()) { // checks only some of the finer films: those on the ball
        options.isWanted = [](const QString& body, const QString& film, int cells) {
            return cells < 30 || (body.startsWith(QLatin1String("Sphere")) &&
                                  !film.contains(QLatin1String("growing")));
        };
    }
    int finer = 0;
    for (const PhysicsResult& result : validatePhysics(FilmModule(), options, {})) {
        qInfo("%s, %s, %d cells: rms %g, axis minus diagonal %g", qPrintable(result.body),
              qPrintable(result.film), result.cells, result.rms, result.anisotropy);
        QVERIFY2(result.passed(), qPrintable(result.body));
        if (result.cells >= 30) {
            ++finer;
            QVERIFY2(std::abs(result.anisotropy) <= 0.002, qPrintable(result.body));
        }
    }
    QVERIFY(finer >= 2);
}

QTEST_GUILESS_MAIN(ProductionClosedFormTest)
#include "ProductionClosedFormTest.moc"

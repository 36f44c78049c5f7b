// Tests that modules outlive changes of the solver interface: the example, built against the oldest
// supported header, and a module that uses named parts.
#include "PluginFolder.h"

#include "base/ProgramName.h"
#include "solver/SolverRegistry.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dipwright;
using namespace dipwright::solver;
using namespace dipwright::test;

namespace {

QString built(const QString& id) {
    return QStringLiteral(DIPWRIGHT_PARTS_MODULE_FOLDER "/") + PluginFolder::moduleName(id);
}

// A ball of 10 mm diameter that is dipped into a film of `lines`² points.
struct BallDip {
    static constexpr int samples = 15;
    std::vector<float> distances;

    DipSetup setup(int lines) {
        distances.clear();
        for (int k = 0; k < samples; ++k) {
            for (int j = 0; j < samples; ++j) {
                for (int i = 0; i < samples; ++i) {
                    distances.push_back(std::hypot(float(i - 7), float(j - 7), float(k - 7)) - 5);
                }
            }
        }
        DipSetup dip;
        dip.film.columns = dip.film.rows = lines;
        dip.film.width = dip.film.depth = 30;
        dip.field = {distances.data(), {samples, samples, samples}, {-7, -7, -7}, 1};
        dip.motion.start = {0, 6, 0};
        dip.motion.travel = 6;
        dip.settings.contactDistance = 0.1;
        return dip;
    }
};

std::vector<float> dipped(const SolverModule& module, const DipSetup& setup) {
    const std::unique_ptr<FilmSolver> film = module.create();
    film->begin(setup);
    while (!film->advance(8).finished) {
    }
    std::vector<float> positions(3 * setup.film.pointCount());
    film->read(positions, {});
    return positions;
}

} // namespace

class SolverPartsTest : public QObject {
    Q_OBJECT

private slots:
    void registry_exampleOfTheOldestInterface_givesTheSameFilm_data() {
        QTest::addColumn<bool>("isShipped");
        QTest::newRow("in its own process") << false;
        QTest::newRow("in the program") << true;
    }
    void registry_exampleOfTheOldestInterface_givesTheSameFilm() {
        QFETCH(const bool, isShipped);
        const PluginFolder folder;
        folder.add(QStringLiteral("example"), built(QStringLiteral("example")));
        folder.add(QStringLiteral("example-3"), built(QStringLiteral("example-3")));
        QJsonObject description = PluginFolder::description(QStringLiteral("example-3"));
        description[QStringLiteral("interface")] = 3;
        folder.describe(description);
        const SolverRegistry registry({folder.path()},
                                      isShipped ? QStringList{folder.path()} : QStringList());
        const SolverModule& older = registry.module(QStringLiteral("example-3"));
        const SolverModule& present = registry.module(QStringLiteral("example"));
        BallDip ball;
        const DipSetup setup = ball.setup(21);
        const std::vector<float> film = dipped(present, setup);
        QVERIFY(*std::min_element(film.begin(), film.end()) < -4);
        QVERIFY(dipped(older, setup) == film);
        QVERIFY(!older.followsPaths());
        QVERIFY(!older.measuredCeiling());
        std::vector<BatchItem> items(3);
        for (BatchItem& item : items) {
            item.setup = setup;
        }
        QVERIFY(older.runBatch(items, nullptr, nullptr));
        for (const BatchItem& item : items) {
            QVERIFY(item.positions == film);
            QVERIFY(item.steps > 1);
        }
    }

    void registry_moduleWithParts_knowsTheProgram() {
        const PluginFolder folder;
        folder.add(QStringLiteral("parts"), built(QStringLiteral("parts")));
        const SolverRegistry registry({folder.path()});
        QCOMPARE(QString::fromUtf8(registry.module(QStringLiteral("parts")).device()),
                 QStringLiteral("Dipwright %1, no moon").arg(programVersion()));
    }

    void module_filmBeyondItsLimit_isRefusedWithASentence() {
        const PluginFolder folder;
        folder.add(QStringLiteral("parts"), built(QStringLiteral("parts")));
        const SolverRegistry registry({folder.path()});
        const auto film = registry.module(QStringLiteral("parts")).create();
        BallDip ball;
        film->begin(ball.setup(10));
        try {
            film->begin(ball.setup(11));
            QFAIL("the film was begun");
        } catch (const std::exception& refusal) {
            QVERIFY2(QString::fromUtf8(refusal.what()).contains(QStringLiteral("at most 100")),
                     refusal.what());
        }
    }
};

QTEST_GUILESS_MAIN(SolverPartsTest)
#include "SolverPartsTest.moc"

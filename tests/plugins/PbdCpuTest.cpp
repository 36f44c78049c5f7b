// Tests the plugin pbd-cpu as the program loads it.

#include "PluginFolder.h"
#include "solver/SolverRegistry.h"
#include "solvers/TestFilm.h"

#include <QStandardPaths>
#include <QTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const QString id = QStringLiteral("pbd-cpu");

// Returns two small dips for each kind of film.
std::vector<solver::DipSetup> dips(const SampledBody& body) {
    std::vector<solver::DipSetup> setups;
    for (const double offset : {0.0, 20.0}) {
        solver::DipSetup setup = paperDip(body, -35, 31, 43, 12);
        setup.motion.start[0] = offset;
        setups.push_back(setup);
        setup.settings.lattice = solver::Lattice::Isotropic;
        setups.push_back(setup);
        setup.settings.support = solver::Support::Water;
        setups.push_back(setup);
    }
    return setups;
}

} // namespace

class PbdCpuTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void pbdCpu_isFoundWithItsDevice();
    void pbdCpu_settings_chooseTheFilm();
    void pbdCpuBatch_equalsSingleDips();
    void pbdCpu_separateProcess_givesTheSameBits();
    void pbdCpuBatch_cancelled_stops();
    void pbdCpu_filmNotBegun_throws();

private:
    SolverRegistry registry_;
};

void PbdCpuTest::pbdCpu_isFoundWithItsDevice() {
    const SolverInfo info = registry_.info(id);
    QVERIFY(info.available);
    QVERIFY(!info.version.isEmpty());
    QVERIFY2(info.device.contains(QChar(u'×')), qPrintable(info.device));
    qInfo("%s", qPrintable(info.device));
}

void PbdCpuTest::pbdCpu_settings_chooseTheFilm() {
    const SampledBody body = sphere(35, 64);
    solver::DipSetup setup = paperDip(body, -35, 31, 43, 12);
    const auto film = registry_.module(id).create();
    const Ending onWater = [&] {
        setup.settings.lattice = solver::Lattice::Isotropic;
        setup.settings.support = solver::Support::Water;
        setup.settings.relaxationTime = std::numeric_limits<double>::infinity();
        return dip(*film, setup);
    }();
    setup.settings.lattice = solver::Lattice::Structural;
    setup.settings.support = solver::Support::None;
    const Ending paper = dip(*film, setup);            // the same object begins a second dip
    QCOMPARE(paper.progress.steps, std::int64_t(144)); // 12 mm at 5 mm/s and 60 Hz
    QVERIFY(onWater.progress.finished);
    const auto sunk = [](const Ending& end) {
        for (std::size_t point = 0; point < end.states.size(); ++point) {
            if (!end.isAdhered(point) && end.position(point).y < -0.1) {
                return true;
            }
        }
        return false;
    };
    QVERIFY(!sunk(onWater));
    QVERIFY(sunk(paper));
}

void PbdCpuTest::pbdCpuBatch_equalsSingleDips() {
    const SampledBody body = sphere(35, 64);
    const solver::SolverModule& module = registry_.module(id);
    std::vector<solver::BatchItem> items;
    for (const solver::DipSetup& setup : dips(body)) {
        items.emplace_back().setup = setup;
    }
    QVERIFY(module.runBatch(items, nullptr, nullptr));
    for (const solver::BatchItem& item : items) {
        const auto film = module.create();
        const Ending single = dip(*film, item.setup);
        QCOMPARE(item.steps, single.progress.steps);
        QVERIFY(item.states == single.states);
        QVERIFY(item.positions == single.positions);
    }
}

// Plugins that do not come with the program run in a separate process.
void PbdCpuTest::pbdCpu_separateProcess_givesTheSameBits() {
    const SampledBody body = sphere(35, 64);
    const PluginFolder folder;
    folder.add(id, registry_.info(id).modulePath);
    const SolverRegistry contained({folder.path()});
    QCOMPARE(contained.info(id).device, registry_.info(id).device);
    std::vector<solver::BatchItem> items, others;
    for (const solver::DipSetup& setup : dips(body)) {
        items.emplace_back().setup = setup;
        others.emplace_back().setup = setup;
    }
    QVERIFY(registry_.module(id).runBatch(items, nullptr, nullptr));
    QVERIFY(contained.module(id).runBatch(others, nullptr, nullptr));
    const auto film = contained.module(id).create();
    for (std::size_t number = 0; number < items.size(); ++number) {
        QVERIFY(items[number].positions == others[number].positions);
        QVERIFY(items[number].states == others[number].states);
        QVERIFY(items[number].marks == others[number].marks);
        QCOMPARE(items[number].steps, others[number].steps);
        const Ending single = dip(*film, items[number].setup);
        QVERIFY(single.positions == items[number].positions);
    }
}

void PbdCpuTest::pbdCpuBatch_cancelled_stops() {
    const SampledBody body = sphere(35, 64);
    std::vector<solver::BatchItem> items;
    for (const solver::DipSetup& setup : dips(body)) {
        items.emplace_back().setup = setup;
    }
    int questions = 0;
    const auto cancelledAfterSome = [](void* context) { return ++*static_cast<int*>(context) > 5; };
    QVERIFY(!registry_.module(id).runBatch(items, cancelledAfterSome, &questions));
    QCOMPARE(questions, 6); // the host is not asked again after it has said yes
}

void PbdCpuTest::pbdCpu_filmNotBegun_throws() {
    const auto film = registry_.module(id).create();
    QVERIFY_THROWS_EXCEPTION(std::exception, film->advance(1));
    std::vector<float> positions(6);
    QVERIFY_THROWS_EXCEPTION(std::exception, film->read(positions, {}));
}

QTEST_GUILESS_MAIN(PbdCpuTest)
#include "PbdCpuTest.moc"

// Modules that misbehave are listed with their reason, and never bring the program down.

#include "PluginFolder.h"
#include "base/Error.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "solver/SolverRegistry.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

QString builtModule(const QString& name) {
    return QStringLiteral(DIPWRIGHT_BAD_MODULES "/") + PluginFolder::moduleName(name);
}

// What the program load_solvers says of a folder, in a life of its own.
struct Listing {
    bool crashed = false;
    QString output;
};
Listing listedByProgram(const PluginFolder& folder, bool retries = false) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (retries) {
        environment.insert(QStringLiteral("DIPWRIGHT_RETRY_SOLVERS"), QStringLiteral("1"));
    }
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(DIPWRIGHT_LOAD_SOLVERS), {folder.path()});
    program.waitForFinished();
    return {program.exitStatus() == QProcess::CrashExit || program.exitCode() != 0,
            QString::fromUtf8(program.readAllStandardOutput())};
}

// A dip of a box with the module `name`; what went wrong, as the user reads it.
QString failureOfDip(const QString& name) {
    const PluginFolder folder;
    folder.add(name, builtModule(name));
    const SolverRegistry registry({folder.path()});
    TexturedMesh model;
    model.mesh = boxMesh({20, 20, 20});
    const Immersion immersion;
    const PosedBody body = posedBody(model, immersion);
    const DistanceField field = buildDistanceField(model.mesh, 64, {});
    try {
        simulateDip(body, field, immersion, {}, {}, registry.module(name), {}, {});
    } catch (const Error& error) {
        return error.sentence();
    }
    return {};
}

} // namespace

class BadModulesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aGoodModuleIsAvailable();
    void badModulesAreListedWithTheirReason_data();
    void badModulesAreListedWithTheirReason();
    void aModuleOfAnotherInterfaceIsNotEvenLoaded_data();
    void aModuleOfAnotherInterfaceIsNotEvenLoaded();
    void automaticChoiceLeavesThemOut();
    void failuresInADipReachTheUser_data();
    void failuresInADipReachTheUser();
    void aModuleThatCrashedTwiceIsLeftOut();
    void beingKilledWhileLoadingIsNotTheModulesFault();
};

void BadModulesTest::initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
}

void BadModulesTest::aGoodModuleIsAvailable() {
    const PluginFolder folder;
    folder.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    const SolverRegistry registry({folder.path()});
    const SolverInfo info = registry.info(QStringLiteral("auto"));
    QVERIFY(info.available);
    QVERIFY(info.reason.isEmpty());
    QCOMPARE(info.id, QStringLiteral("good"));
    QCOMPARE(info.device, QStringLiteral("A device"));
    QCOMPARE(&registry.module(QStringLiteral("good")), &registry.module(QStringLiteral("auto")));
}

void BadModulesTest::badModulesAreListedWithTheirReason_data() {
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("entry") << "not today";
    QTest::newRow("entry-unknown") << "unknown exception";
    QTest::newRow("old") << "does not fit this program's solver interface 3";
    QTest::newRow("name") << "no entry point";
    QTest::newRow("device") << "There is no such device here";
    QTest::newRow("question") << "do not ask";
}

void BadModulesTest::badModulesAreListedWithTheirReason() {
    QFETCH(QString, reasonPart);
    const QString id = QString::fromLatin1(QTest::currentDataTag());
    const PluginFolder folder;
    folder.add(id, builtModule(id));
    const SolverRegistry registry({folder.path()});
    const auto solvers = registry.solvers();
    QCOMPARE(solvers.size(), std::size_t(1));
    QVERIFY(!solvers.front().available);
    QVERIFY2(solvers.front().reason.contains(reasonPart), qPrintable(solvers.front().reason));
    try {
        registry.module(id);
        QFAIL("a bad module was given out");
    } catch (const Error& error) {
        QVERIFY2(error.message().contains(reasonPart), qPrintable(error.message()));
    }
}

void BadModulesTest::aModuleOfAnotherInterfaceIsNotEvenLoaded_data() {
    QTest::addColumn<int>("version");
    QTest::newRow("older") << 2;
    QTest::newRow("newer") << solver::interfaceVersion + 1;
}

void BadModulesTest::aModuleOfAnotherInterfaceIsNotEvenLoaded() {
    QFETCH(int, version);
    const PluginFolder folder;
    folder.add(QStringLiteral("load"), builtModule(QStringLiteral("load"))); // aborts when loaded
    QJsonObject description = PluginFolder::description(QStringLiteral("load"));
    description[QStringLiteral("interface")] = version;
    folder.describe(description);
    const auto solvers = SolverRegistry({folder.path()}).solvers();
    QCOMPARE(solvers.size(), std::size_t(1));
    QVERIFY(!solvers.front().available);
    QCOMPARE(solvers.front().reason,
             QStringLiteral("It was built for solver interface %1, and this program has 3; get it "
                            "for this version of the program, or build it anew")
                 .arg(version));
}

void BadModulesTest::automaticChoiceLeavesThemOut() {
    const PluginFolder folder;
    for (const char* name : {"good", "entry", "device"}) {
        folder.add(QString::fromLatin1(name), builtModule(QString::fromLatin1(name)));
    }
    QJsonObject description = PluginFolder::description(QStringLiteral("entry"));
    description[QStringLiteral("priority")] = 1000;
    folder.describe(description);
    QCOMPARE(SolverRegistry({folder.path()}).info(QStringLiteral("auto")).id,
             QStringLiteral("good"));
}

void BadModulesTest::failuresInADipReachTheUser_data() {
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("create") << "out of memory";
    QTest::newRow("begin") << "out of film";
    QTest::newRow("advance") << "out of water";
    QTest::newRow("advance-unknown") << "";
    QTest::newRow("read") << "out of ink";
}

void BadModulesTest::failuresInADipReachTheUser() {
    QFETCH(QString, reasonPart);
    const QString failure = failureOfDip(QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(!failure.isEmpty());
    QVERIFY2(failure.contains(reasonPart), qPrintable(failure));
}

void BadModulesTest::aModuleThatCrashedTwiceIsLeftOut() {
    const PluginFolder folder;
    folder.add(QStringLiteral("crashing"), builtModule(QStringLiteral("abort")));
    folder.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    QVERIFY(listedByProgram(folder).crashed);
    QVERIFY(listedByProgram(folder).crashed); // it may have been something else once
    for (int start = 0; start < 2; ++start) {
        const Listing next = listedByProgram(folder);
        QVERIFY(!next.crashed);
        QVERIFY2(next.output.contains(QLatin1String("crashing It has crashed twice")),
                 qPrintable(next.output));
        QVERIFY(next.output.contains(QLatin1String("good available")));
    }
    QVERIFY(listedByProgram(folder, true).crashed); // asked to try again
    QVERIFY(listedByProgram(folder).crashed);
    QVERIFY(!listedByProgram(folder).crashed);
    // A module that was replaced gets a new chance.
    folder.add(QStringLiteral("crashing"), builtModule(QStringLiteral("good")));
    QVERIFY(listedByProgram(folder).output.contains(QLatin1String("crashing available")));
}

void BadModulesTest::beingKilledWhileLoadingIsNotTheModulesFault() {
    const PluginFolder folder;
    folder.add(QStringLiteral("killed"), builtModule(QStringLiteral("killed")));
    for (int start = 0; start < 4; ++start) {
        QVERIFY(listedByProgram(folder).crashed);
    }
    folder.add(QStringLiteral("killed"), builtModule(QStringLiteral("good")));
    QVERIFY(listedByProgram(folder).output.contains(QLatin1String("killed available")));
}

QTEST_GUILESS_MAIN(BadModulesTest)
#include "BadModulesTest.moc"

// Tests that misbehaving solver modules are listed with their reason and never crash the program.

#include "PluginFolder.h"
#include "TestFolders.h"
#include "base/Error.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "solver/SolverRegistry.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTest>
#include <QTranslator>
#include <chrono>
#include <thread>

#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

using namespace dipwright;
using namespace dipwright::test;

namespace {

QString builtModule(const QString& name) {
    return badModuleFolder("/") + PluginFolder::moduleName(name);
}

// The output of the program load_solvers for a folder. The program runs in a separate process.
struct Listing {
    bool crashed = false;
    QString output;
};
Listing listedByProgram(const PluginFolder& folder, const QStringList& more = {},
                        bool retries = false) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (retries) {
        environment.insert(QStringLiteral("DIPWRIGHT_RETRY_SOLVERS"), QStringLiteral("1"));
    }
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(DIPWRIGHT_LOAD_SOLVERS), QStringList{folder.path()} + more);
    program.waitForFinished();
    return {program.exitStatus() == QProcess::CrashExit || program.exitCode() != 0,
            QString::fromUtf8(program.readAllStandardOutput())};
}

void openToOthers(const PluginFolder& folder) {
    QVERIFY(QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::WriteOwner |
                                                     QFile::ExeOwner | QFile::WriteOther));
}

void linkAll(const PluginFolder& from, const PluginFolder& to) {
    const QStringList names = QDir(to.path()).entryList(QDir::Files);
    for (const QString& name : names) {
        QVERIFY(QFile::link(to.filePath(name), from.filePath(name)));
    }
}

// Returns whether a running process holds the lock on the file.
bool isLocked(const QString& path) {
#ifdef Q_OS_UNIX
    const int file = ::open(QFile::encodeName(path).constData(), O_RDWR | O_CLOEXEC);
    const bool isTaken = file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) != 0;
    ::close(file);
    return isTaken;
#else
    return QFile::exists(path) && false;
#endif
}

// Dips a box with the module `name`. Returns the error as the user reads it.
QString failureOfDip(const QString& name, const Progress& progress = {}) {
    const PluginFolder folder;
    folder.add(name, builtModule(name));
    const SolverRegistry registry({folder.path()});
    const TriangleMesh box = boxMesh({20, 20, 20});
    const Immersion immersion;
    const PosedBody body = posedBody(box, immersion);
    const DistanceField field = buildDistanceField(box, 64, {});
    try {
        simulateDip(body, field, immersion, {}, {}, registry.module(name), progress, {});
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
    void solverRegistry_goodModule_isAvailable();
    void solverRegistry_badModule_isListedWithItsReason_data();
    void solverRegistry_badModule_isListedWithItsReason();
    void solverRegistry_reason_isTranslated_data();
    void solverRegistry_reason_isTranslated();
    void solverRegistry_otherInterfaceVersion_isNotLoaded_data();
    void solverRegistry_otherInterfaceVersion_isNotLoaded();
    void solverRegistry_auto_skipsBadModules();
    void solverRegistry_auto_doesNotLoadLowerPriorities();
    void solverRegistry_hangWhileLoading_canBeCancelled();
    void simulateDip_badModule_reportsTheFailure_data();
    void simulateDip_badModule_reportsTheFailure();
    void simulateDip_hangingModule_canBeCancelled();
    void runBatch_badModule_reportsTheFailure_data();
    void runBatch_badModule_reportsTheFailure();
    void solverInfo_longText_isCutToOneLine();
    void measuredCeiling_impossibleValue_isNone();
    void containedModule_childProcess_endsWithTheModule_data();
    void containedModule_childProcess_endsWithTheModule();
    void containedModule_programKilled_childProcessEnds();
    void containedModule_crashedTwice_isLeftOut_data();
    void containedModule_crashedTwice_isLeftOut();
    void shippedModule_hungOnce_isContained();
    void shippedModule_crashedTwice_isLeftOut();
    void shippedModule_folderWritableByOthers_isLoaded();
    void userModule_writableByOthers_isNotLoaded();
    void userModule_linkWritableByOthers_isNotFollowed();
    void userModule_usersOwnLink_isFollowed();
    void loadingModule_killed_doesNotCountAsCrash();
};

void BadModulesTest::initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "1");
}

void BadModulesTest::solverRegistry_goodModule_isAvailable() {
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

void BadModulesTest::solverRegistry_badModule_isListedWithItsReason_data() {
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("entry") << "not today";
    QTest::newRow("entry-unknown") << "unknown exception";
    QTest::newRow("old") << "does not match this program's solver interface 4";
    QTest::newRow("name") << "no entry point";
    QTest::newRow("device") << "There is no such device here";
    QTest::newRow("device-long") << "It said far too much: xxx";
    QTest::newRow("device-empty") << "It cannot run here and does not say why";
    QTest::newRow("question") << "do not ask";
}

void BadModulesTest::solverRegistry_badModule_isListedWithItsReason() {
    QFETCH(QString, reasonPart);
    const QString id = QString::fromLatin1(QTest::currentDataTag());
    const PluginFolder folder;
    folder.add(id, builtModule(id));
    const SolverRegistry registry({folder.path()});
    const auto solvers = registry.solvers();
    QCOMPARE(solvers.size(), std::size_t(1));
    QVERIFY(!solvers.front().available);
    QVERIFY2(solvers.front().reason.contains(reasonPart), qPrintable(solvers.front().reason));
    QVERIFY(solvers.front().reason.size() <= 500);
    try {
        registry.module(id);
        QFAIL("a bad module was returned, expected an error");
    } catch (const Error& error) {
        QVERIFY2(error.message().contains(reasonPart), qPrintable(error.message()));
    }
}

void BadModulesTest::solverRegistry_reason_isTranslated_data() {
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("entry") << "+Its module failed at start: not today";
    QTest::newRow("entry-unknown") << "+Its module failed at start with an unknown";
    QTest::newRow("old") << "+Its module does not match";
    QTest::newRow("name") << "+Its module has no entry point";
    QTest::newRow("load") << "+it crashed";
}

// Most reasons come from a process that has no translations.
void BadModulesTest::solverRegistry_reason_isTranslated() {
    class Marking : public QTranslator {
    public:
        bool isEmpty() const override { return false; }
        QString translate(const char*, const char* text, const char*, int) const override {
            return QLatin1Char('+') + QString::fromUtf8(text);
        }
    };
    QFETCH(QString, reasonPart);
    const QString id = QString::fromLatin1(QTest::currentDataTag());
    const PluginFolder folder;
    folder.add(id, builtModule(id));
    Marking language;
    QCoreApplication::installTranslator(&language);
    const QString reason = SolverRegistry({folder.path()}).found(id)->reason;
    QCoreApplication::removeTranslator(&language);
    QVERIFY2(reason.contains(reasonPart), qPrintable(reason));
}

void BadModulesTest::solverRegistry_otherInterfaceVersion_isNotLoaded_data() {
    QTest::addColumn<int>("version");
    QTest::newRow("older") << 2;
    QTest::newRow("newer") << solver::interfaceVersion + 1;
}

void BadModulesTest::solverRegistry_otherInterfaceVersion_isNotLoaded() {
    QFETCH(int, version);
    const PluginFolder folder;
    folder.add(QStringLiteral("load"), builtModule(QStringLiteral("load"))); // aborts when loaded
    QJsonObject description = PluginFolder::description(QStringLiteral("load"));
    description[QStringLiteral("interface")] = version;
    folder.describe(description);
    const auto solvers = SolverRegistry({folder.path()}).solvers();
    QCOMPARE(solvers.size(), std::size_t(1));
    QVERIFY(!solvers.front().available);
    QCOMPARE(
        solvers.front().reason,
        QStringLiteral("It was built for solver interface %1, but this program has 3 to 4; get "
                       "the plugin for this version of the program, or build it again")
            .arg(version));
}

void BadModulesTest::solverRegistry_auto_skipsBadModules() {
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

// A module that hangs while it is loaded does not delay the use of a better module.
void BadModulesTest::solverRegistry_auto_doesNotLoadLowerPriorities() {
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "600");
    const PluginFolder folder;
    folder.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    folder.add(QStringLiteral("hang"), builtModule(QStringLiteral("hang")));
    QJsonObject description = PluginFolder::description(QStringLiteral("hang"));
    description[QStringLiteral("priority")] = 0;
    folder.describe(description);
    QCOMPARE(SolverRegistry({folder.path()}).info(QStringLiteral("auto")).id,
             QStringLiteral("good"));
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "1");
}

void BadModulesTest::solverRegistry_hangWhileLoading_canBeCancelled() {
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "600");
    const PluginFolder folder;
    folder.add(QStringLiteral("hang"), builtModule(QStringLiteral("hang")));
    const SolverRegistry registry({folder.path()});
    CancelToken cancelToken;
    std::thread user([cancelToken]() mutable {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        cancelToken.cancel();
    });
    QVERIFY_EXCEPTION_THROWN(registry.module(QStringLiteral("hang"), cancelToken), Cancelled);
    user.join();
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "1");
    // The user cancelled the search, which does not count against the module.
    const std::optional<SolverInfo> next = registry.found(QStringLiteral("hang"));
    QVERIFY2(next->reason.contains(QLatin1String("did not respond for 1 s")),
             qPrintable(next->reason));
}

void BadModulesTest::simulateDip_badModule_reportsTheFailure_data() {
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("create") << "out of memory";
    QTest::newRow("begin") << "out of film";
    QTest::newRow("advance") << "out of water";
    QTest::newRow("advance-unknown") << "unknown exception";
    QTest::newRow("read") << "out of ink";
    QTest::newRow("create-nothing") << "created no film";
    QTest::newRow("create-unknown") << "unknown exception";
    QTest::newRow("advance-crash") << "it crashed";
    QTest::newRow("advance-exit") << "process ended unexpectedly";
    QTest::newRow("advance-hang") << "did not respond for 1 s";
    QTest::newRow("advance-giant") << "answer was impossibly long";
    QTest::newRow("advance-idle") << "makes no progress";
    QTest::newRow("advance-nonsense") << "impossible";
    QTest::newRow("advance-steps") << "impossible number of steps";
    QTest::newRow("advance-deep") << "impossible number of steps";
    QTest::newRow("advance-crawl") << "makes no progress";
    QTest::newRow("advance-still") << "makes no progress";
    QTest::newRow("advance-equilibrium") << "impossible convergence values";
    QTest::newRow("advance-force") << "impossible convergence values";
    QTest::newRow("advance-empty") << "unknown exception";
    QTest::newRow("long") << "It said far too much: xxx";
    QTest::newRow("read-crash") << "it crashed";
    QTest::newRow("read-states") << "an invalid state";
    QTest::newRow("read-positions") << "unstable";
    QTest::newRow("read-marks") << "an invalid mark";
}

void BadModulesTest::simulateDip_badModule_reportsTheFailure() {
    QFETCH(QString, reasonPart);
    const QString failure = failureOfDip(QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(!failure.isEmpty());
    QVERIFY2(failure.contains(reasonPart), qPrintable(failure));
    QVERIFY(failure.size() <= 600); // up to 500 of these characters are the module's text
}

void BadModulesTest::simulateDip_hangingModule_canBeCancelled() {
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "600");
    Progress progress;
    std::thread user([cancel = progress.cancelToken]() mutable {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        cancel.cancel();
    });
    QVERIFY_EXCEPTION_THROWN(failureOfDip(QStringLiteral("advance-hang"), progress), Cancelled);
    user.join();
    qputenv("DIPWRIGHT_SOLVER_SECONDS", "1");
}

void BadModulesTest::runBatch_badModule_reportsTheFailure_data() {
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("good") << "no result for some films of a batch";
    QTest::newRow("batch-unknown") << "unknown exception";
    QTest::newRow("batch-crash") << "it crashed";
    QTest::newRow("batch-stops") << "stopped without being cancelled";
    QTest::newRow("batch-hang") << "did not respond for 1 s";
    QTest::newRow("batch-steps") << "impossible number of steps";
    QTest::newRow("batch-equilibrium") << "impossible convergence values";
}

void BadModulesTest::runBatch_badModule_reportsTheFailure() {
    QFETCH(QString, reasonPart);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    const PluginFolder folder;
    folder.add(name, builtModule(name));
    const SolverRegistry registry({folder.path()});
    std::vector<solver::BatchItem> items(2);
    for (solver::BatchItem& item : items) {
        item.setup.film = {8, 8, 100, 100};
    }
    try {
        registry.module(name).runBatch(items, nullptr, nullptr);
        QFAIL("a bad batch was accepted, expected an error");
    } catch (const std::exception& failure) {
        QVERIFY2(QString::fromUtf8(failure.what()).contains(reasonPart), failure.what());
    }
}

void BadModulesTest::solverInfo_longText_isCutToOneLine() {
    const PluginFolder folder;
    folder.add(QStringLiteral("long"), builtModule(QStringLiteral("long")));
    QJsonObject description = PluginFolder::description(QStringLiteral("long"));
    description[QStringLiteral("name")] = QStringLiteral("A name\nof two lines");
    folder.describe(description);
    for (const QStringList& shipped : {QStringList(), QStringList(folder.path())}) {
        const SolverRegistry registry({folder.path()}, shipped);
        const SolverInfo info = registry.info(QStringLiteral("long"));
        QVERIFY2(info.device.startsWith(QLatin1String("It said far too much: xxx")),
                 qPrintable(info.device.left(600)));
        QCOMPARE(info.device.size(), 500);
        QCOMPARE(QString::fromUtf8(registry.module(info.id).device()), info.device);
        QCOMPARE(info.name, QStringLiteral("A name of two lines"));
    }
}

void BadModulesTest::measuredCeiling_impossibleValue_isNone() {
    const PluginFolder folder;
    for (const char* name : {"good", "ceiling-endless", "ceiling-crash"}) {
        folder.add(QString::fromLatin1(name), builtModule(QString::fromLatin1(name)));
    }
    const SolverRegistry registry({folder.path()});
    QVERIFY(!registry.module(QStringLiteral("good")).measuredCeiling());
    QVERIFY(!registry.module(QStringLiteral("ceiling-endless")).measuredCeiling());
    QVERIFY_EXCEPTION_THROWN(registry.module(QStringLiteral("ceiling-crash")).measuredCeiling(),
                             std::runtime_error);
}

void BadModulesTest::containedModule_childProcess_endsWithTheModule_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("at the end of the dip") << "fork";
    QTest::newRow("when its process ends itself") << "fork-exit";
    QTest::newRow("when it is stopped") << "fork-hang";
}

void BadModulesTest::containedModule_childProcess_endsWithTheModule() {
#ifdef Q_OS_UNIX
    QFETCH(QString, name);
    const QTemporaryDir place;
    const QString lock = place.filePath(QStringLiteral("lock"));
    qputenv("DIPWRIGHT_BAD_LOCK", QFile::encodeName(lock));
    failureOfDip(name);
    QVERIFY(QFile::exists(lock)); // the child process was started
    QTRY_VERIFY(!isLocked(lock));
#endif
}

void BadModulesTest::containedModule_programKilled_childProcessEnds() {
#ifdef Q_OS_UNIX
    const PluginFolder folder;
    folder.add(QStringLiteral("fork-hang"), builtModule(QStringLiteral("fork-hang")));
    const QString lock = folder.filePath(QStringLiteral("lock"));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DIPWRIGHT_BAD_LOCK"), lock);
    environment.insert(QStringLiteral("DIPWRIGHT_SOLVER_SECONDS"), QStringLiteral("600"));
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(DIPWRIGHT_LOAD_SOLVERS),
                  {folder.path(), QStringLiteral("contained"), QStringLiteral("dip")});
    QTRY_VERIFY(isLocked(lock));
    program.kill();
    program.waitForFinished();
    QTRY_VERIFY(!isLocked(lock));
#endif
}

void BadModulesTest::containedModule_crashedTwice_isLeftOut_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("crash while it is loaded") << "load"
                                              << "it crashed";
    QTest::newRow("crash in the search for devices") << "abort"
                                                     << "it crashed";
    QTest::newRow("hang") << "hang"
                          << "it did not respond";
}

void BadModulesTest::containedModule_crashedTwice_isLeftOut() {
    QFETCH(QString, name);
    QFETCH(QString, reasonPart);
    const PluginFolder folder;
    folder.add(QStringLiteral("crashing"), builtModule(name));
    folder.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    for (int start = 0; start < 4; ++start) {
        const Listing listing = listedByProgram(folder);
        QVERIFY(!listing.crashed);
        QVERIFY(listing.output.contains(QLatin1String("good available")));
        QVERIFY2(listing.output.contains(start < 2 ? QStringLiteral("crashing ") + reasonPart
                                                   : QStringLiteral("It has crashed twice")),
                 qPrintable(listing.output));
    }
    QVERIFY(listedByProgram(folder, {}, true)
                .output.contains(reasonPart)); // the user requests another try
    // A module that was replaced is tried again.
    folder.add(QStringLiteral("crashing"), builtModule(QStringLiteral("good")));
    QVERIFY(listedByProgram(folder).output.contains(QLatin1String("crashing available")));
}

// If a module hangs inside the program, the program can only be ended as a whole. The next program
// runs the module in a separate process, which it can end.
void BadModulesTest::shippedModule_hungOnce_isContained() {
    const PluginFolder folder;
    folder.add(QStringLiteral("hanging"), builtModule(QStringLiteral("advance-hang")));
    QProcess program;
    program.start(QStringLiteral(DIPWRIGHT_LOAD_SOLVERS),
                  {folder.path(), QStringLiteral("shipped"), QStringLiteral("dip")});
    QVERIFY(program.waitForStarted());
    program.waitForFinished(4000); // longer than a call to the module may take
    QCOMPARE(program.state(), QProcess::Running);
    program.kill();
    program.waitForFinished();
    const Listing next =
        listedByProgram(folder, {QStringLiteral("shipped"), QStringLiteral("dip")});
    QVERIFY(!next.crashed);
    QVERIFY2(next.output.contains(QLatin1String("did not respond for 1 s")),
             qPrintable(next.output));
}

// Modules that come with the program are loaded into the program's own process.
void BadModulesTest::shippedModule_crashedTwice_isLeftOut() {
    const PluginFolder folder;
    const QStringList shipped{QStringLiteral("shipped")};
    folder.add(QStringLiteral("crashing"), builtModule(QStringLiteral("abort")));
    folder.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    QVERIFY(listedByProgram(folder, shipped).crashed);
    // The crash may have had another cause, so the module is tried again in a separate process.
    QVERIFY(listedByProgram(folder, shipped).output.contains(QLatin1String("crashing it crashed")));
    for (int start = 0; start < 2; ++start) {
        const Listing next = listedByProgram(folder, shipped);
        QVERIFY(!next.crashed);
        QVERIFY2(next.output.contains(QLatin1String("crashing It has crashed twice")),
                 qPrintable(next.output));
        QVERIFY(next.output.contains(QLatin1String("good available")));
    }
}

// When root unpacks an archive, the files keep the user ids of the packer. A shipped module that
// has crashed once then runs in a separate process; it is not refused because of its folder.
void BadModulesTest::shippedModule_folderWritableByOthers_isLoaded() {
    const PluginFolder folder;
    const QStringList shipped{QStringLiteral("shipped")};
    folder.add(QStringLiteral("crashing"), builtModule(QStringLiteral("abort")));
    openToOthers(folder);
    QVERIFY(listedByProgram(folder, shipped).crashed);
    const Listing next = listedByProgram(folder, shipped);
    QVERIFY2(next.output.contains(QLatin1String("crashing it crashed")), qPrintable(next.output));
}

void BadModulesTest::loadingModule_killed_doesNotCountAsCrash() {
    const PluginFolder folder;
    const QStringList shipped{QStringLiteral("shipped")};
    folder.add(QStringLiteral("killed"), builtModule(QStringLiteral("killed")));
    for (int start = 0; start < 4; ++start) {
        QVERIFY(listedByProgram(folder, shipped).crashed);
        QVERIFY(listedByProgram(folder).output.contains(QLatin1String("was killed")));
    }
}

void BadModulesTest::userModule_writableByOthers_isNotLoaded() {
    const PluginFolder folder;
    folder.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    QVERIFY(listedByProgram(folder).output.contains(QLatin1String("good available")));
    openToOthers(folder);
    const Listing listing = listedByProgram(folder);
    QVERIFY2(listing.output.contains(QLatin1String("Other users can write to ") + folder.path()),
             qPrintable(listing.output));
}

// The target of the links is safe, but other users can change the links.
void BadModulesTest::userModule_linkWritableByOthers_isNotFollowed() {
#ifdef Q_OS_UNIX
    const PluginFolder safe, open;
    safe.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    linkAll(open, safe);
    openToOthers(open);
    const Listing listing = listedByProgram(open);
    QVERIFY2(listing.output.contains(QLatin1String("Other users can write to ") + open.path()),
             qPrintable(listing.output));
#endif
}

// Packagers may use links. The file behind the link is loaded.
void BadModulesTest::userModule_usersOwnLink_isFollowed() {
#ifdef Q_OS_UNIX
    const PluginFolder place, folder;
    place.add(QStringLiteral("good"), builtModule(QStringLiteral("good")));
    linkAll(folder, place);
    QVERIFY(listedByProgram(folder).output.contains(QLatin1String("good available")));
    const SolverInfo info = SolverRegistry({folder.path()}).info(QStringLiteral("good"));
    QCOMPARE(info.modulePath,
             QFileInfo(place.filePath(PluginFolder::moduleName(QStringLiteral("good"))))
                 .canonicalFilePath());
#endif
}

QTEST_GUILESS_MAIN(BadModulesTest)
#include "BadModulesTest.moc"

// How SolverRegistry treats the files that it finds. No plugin code is loaded.

#include "solver/SolverRegistry.h"
#include "PluginFolder.h"
#include "base/Error.h"
#include "solver/FilePermissions.h"
#include "solver/LoadMarker.h"

#include <QDir>
#include <QStandardPaths>
#include <QTest>
#include <algorithm>
#include <vector>

#ifdef Q_OS_UNIX
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace dipwright;
using namespace dipwright::test;

namespace {

SolverInfo onlySolver(const PluginFolder& folder) {
    const auto solvers = SolverRegistry({folder.path()}).solvers();
    return solvers.size() == 1 ? solvers.front() : SolverInfo{};
}

} // namespace

class SolverRegistryTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void solverRegistry_emptyOrMissingFolder_hasNoSolvers();
    void solverRegistry_badDescription_isListedWithItsReason_data();
    void solverRegistry_badDescription_isListedWithItsReason();
    void solverRegistry_missingModule_isNamed();
    void solverRegistry_pipeOrDeviceAsDescription_isNotRead();
    void solverRegistry_priorityOutOfRange_isRefused();
    void solverRegistry_fileThatIsNoModule_isRefused();
    void solverRegistry_sameIdTwice_firstFolderWins();
    void solverRegistry_unknownSolver_errorListsTheSolvers();
    void standardFolders_shippedPlugins_comeFirst();
    void crashesOf_moduleBeingLoaded_isZero();
    void writableByOthers_groupFolder_isReportedUnlessGroupIsPrivate();
};

void SolverRegistryTest::initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
}

void SolverRegistryTest::solverRegistry_emptyOrMissingFolder_hasNoSolvers() {
    const PluginFolder empty;
    const SolverRegistry registry({empty.path(), empty.filePath(QStringLiteral("missing"))});
    QVERIFY(registry.solvers().empty());
    QVERIFY_THROWS_EXCEPTION(Error, registry.module(QStringLiteral("auto")));
}

void SolverRegistryTest::solverRegistry_badDescription_isListedWithItsReason_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QJsonValue>("value");
    QTest::addColumn<QString>("reasonPart");
    const auto row = [](const char* name, const char* key, const QJsonValue& value,
                        const char* reasonPart) {
        QTest::newRow(name) << QString::fromLatin1(key) << value << QString::fromLatin1(reasonPart);
    };
    row("another format", "format", "something", "does not describe a solver");
    row("newer interface", "interface", 99, "interface 99");
    row("no interface", "interface", QJsonValue::Null, "interface");
    row("interface as text", "interface", "1", "interface");
    row("no id", "id", QJsonValue::Null, "\"id\"");
    row("id with spaces", "id", "my solver", "id may contain");
    row("id that means any", "id", "auto", "id may contain");
    row("no name", "name", " ", "\"name\"");
    row("no version", "version", 3, "\"version\"");
    row("no device", "device", QJsonValue::Null, "\"device\"");
    row("no vendor", "vendor", QJsonValue::Null, "\"vendor\"");
    row("no module", "module", QJsonValue::Null, "\"module\"");
    row("module elsewhere", "module", "../solver.so", "same folder as its description");
}

void SolverRegistryTest::solverRegistry_badDescription_isListedWithItsReason() {
    QFETCH(QString, key);
    QFETCH(QJsonValue, value);
    QFETCH(QString, reasonPart);
    const PluginFolder folder;
    QJsonObject description = PluginFolder::description(QStringLiteral("good"));
    folder.write(PluginFolder::moduleName(QStringLiteral("good")), "not reached");
    description[key] = value;
    folder.describe(description, QStringLiteral("plugin.json"));
    const SolverInfo info = onlySolver(folder);
    QVERIFY(!info.id.isEmpty());
    QVERIFY(!info.available);
    QVERIFY2(info.reason.contains(reasonPart), qPrintable(info.reason));
}

void SolverRegistryTest::solverRegistry_missingModule_isNamed() {
    const PluginFolder folder;
    folder.describe(PluginFolder::description(QStringLiteral("good")));
    const SolverInfo info = onlySolver(folder);
    QCOMPARE(info.id, QStringLiteral("good"));
    QCOMPARE(info.name, QStringLiteral("The solver good"));
    QVERIFY(!info.available);
    QVERIFY(info.reason.contains(PluginFolder::moduleName(QStringLiteral("good"))));
}

// Reading the device would never end; reading the pipe would never begin.
void SolverRegistryTest::solverRegistry_pipeOrDeviceAsDescription_isNotRead() {
#ifdef Q_OS_UNIX
    const PluginFolder place;
    const QString pipe = place.filePath(QStringLiteral("pipe"));
    QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    for (const QString& target : {QStringLiteral("/dev/zero"), pipe}) {
        const PluginFolder folder;
        QVERIFY(QFile::link(target, folder.filePath(QStringLiteral("good.json"))));
        const SolverInfo info = onlySolver(folder);
        QVERIFY(!info.available);
        QVERIFY2(info.reason.contains(QLatin1String("a pipe or a device")),
                 qPrintable(info.reason));
    }
#endif
}

void SolverRegistryTest::solverRegistry_priorityOutOfRange_isRefused() {
    const auto described = [](const QJsonValue& priority) {
        const PluginFolder folder;
        QJsonObject description = PluginFolder::description(QStringLiteral("good"));
        description[QStringLiteral("priority")] = priority;
        folder.describe(description);
        return onlySolver(folder);
    };
    for (const QJsonValue& priority :
         {QJsonValue(1e99), QJsonValue(1001), QJsonValue(-1001), QJsonValue(1.5),
          QJsonValue(-2147483648.0), QJsonValue(QStringLiteral("high")), QJsonValue()}) {
        const SolverInfo info = described(priority);
        QVERIFY(!info.available);
        QVERIFY2(info.reason.contains(QLatin1String("from -1000 to 1000")),
                 qPrintable(info.reason));
    }
    QCOMPARE(described(1000).priority, 1000);
    QCOMPARE(described(-1000).priority, -1000);
    QCOMPARE(described(QJsonValue(QJsonValue::Undefined)).priority, 0);
}

void SolverRegistryTest::solverRegistry_fileThatIsNoModule_isRefused() {
    const PluginFolder folder;
    const QString name = PluginFolder::moduleName(QStringLiteral("good"));
    folder.describe(PluginFolder::description(QStringLiteral("good")));
    for (const QByteArray& content : {QByteArray(), QByteArray("This is a letter.\n"),
                                      QByteArray("\x7f"
                                                 "ELF\x02\x01\x01",
                                                 7)}) {
        folder.write(name, content);
        const auto solvers = SolverRegistry({folder.path()}, {folder.path()}).solvers();
        QCOMPARE(solvers.size(), std::size_t(1));
        const SolverInfo& info = solvers.front();
        QVERIFY(!info.available);
        QVERIFY2(info.reason.contains(QLatin1String("cannot be loaded")), qPrintable(info.reason));
    }
    for (const QByteArray& content : {QByteArray(), QByteArray("{\"format\":\"dipwright-sol"),
                                      QByteArray("[1, 2]"), QByteArray(100000, ' ')}) {
        folder.write(QStringLiteral("good.json"), content);
        QVERIFY(!onlySolver(folder).available);
        QVERIFY(!onlySolver(folder).reason.isEmpty());
    }
}

void SolverRegistryTest::solverRegistry_sameIdTwice_firstFolderWins() {
    const PluginFolder first, second;
    QJsonObject description = PluginFolder::description(QStringLiteral("same"));
    second.describe(description);
    description[QStringLiteral("name")] = QStringLiteral("The first");
    first.describe(description);
    second.describe(PluginFolder::description(QStringLiteral("another")));
    const auto solvers = SolverRegistry({first.path(), second.path()}).solvers();
    QCOMPARE(solvers.size(), std::size_t(3));
    QCOMPARE(solvers[0].id, QStringLiteral("another"));
    QCOMPARE(solvers[1].id, QStringLiteral("same"));
    QCOMPARE(solvers[1].name, QStringLiteral("The first"));
    QCOMPARE(solvers[2].id, QStringLiteral("same-2")); // the id by which it can be chosen
}

void SolverRegistryTest::solverRegistry_unknownSolver_errorListsTheSolvers() {
    const PluginFolder folder;
    folder.describe(PluginFolder::description(QStringLiteral("good")));
    const SolverRegistry registry({folder.path()});
    try {
        registry.module(QStringLiteral("better"));
        QFAIL("a missing solver was found, expected a refusal");
    } catch (const Error& error) {
        QCOMPARE(error.where(), QStringLiteral("better"));
        QVERIFY(error.message().contains(QLatin1String("auto, good")));
    }
}

void SolverRegistryTest::standardFolders_shippedPlugins_comeFirst() {
    const QByteArray before = qgetenv("DIPWRIGHT_PLUGIN_PATH");
    const QString path = QStringLiteral("/one") + QDir::listSeparator() + QStringLiteral("/two");
    qputenv("DIPWRIGHT_PLUGIN_PATH", path.toUtf8());
    const QStringList folders = SolverRegistry::standardFolders();
    qputenv("DIPWRIGHT_PLUGIN_PATH", before);
    const QString program = QCoreApplication::applicationDirPath();
    QCOMPARE(folders.size(), 6);
    QCOMPARE(folders[0], program + QStringLiteral("/plugins"));
    // In an installation the program's folder is beside the libraries' folder.
    QVERIFY2(folders[2].startsWith(QFileInfo(program).path()), qPrintable(folders[2]));
    QVERIFY2(folders[2].endsWith(QLatin1String("/dipwright/plugins")), qPrintable(folders[2]));
    QCOMPARE(folders[3], QStringLiteral("/one"));
    QCOMPARE(folders[4], QStringLiteral("/two"));
    QVERIFY2(folders[5].endsWith(QLatin1String("/plugins")), qPrintable(folders[5]));
}

void SolverRegistryTest::crashesOf_moduleBeingLoaded_isZero() {
    const PluginFolder folder;
    folder.write(QStringLiteral("module"), "x");
    const QString module = folder.filePath(QStringLiteral("module"));
    {
        const LoadMarker marker(module);
        QCOMPARE(crashesOf(module), 0);
    }
    QCOMPARE(crashesOf(module), 0);
}

// Tries every group that this user can give a folder to.
void SolverRegistryTest::writableByOthers_groupFolder_isReportedUnlessGroupIsPrivate() {
#ifdef Q_OS_UNIX
    const PluginFolder folder;
    const QByteArray path = QFile::encodeName(folder.path());
    QCOMPARE(::chmod(path.constData(), 0700), 0);
    QCOMPARE(writableByOthers(folder.path()), QString());
    QCOMPARE(::chmod(path.constData(), 0770), 0);
    const passwd* user = ::getpwuid(::geteuid());
    const QByteArray name = user ? user->pw_name : "";
    std::vector<gid_t> groups(65536);
    groups.resize(std::size_t(std::max(::getgroups(int(groups.size()), groups.data()), 0)));
    groups.insert(groups.end(), {::getegid(), 1, 12345}); // root may give it to any group
    for (const gid_t id : groups) {
        if (::chown(path.constData(), ::uid_t(-1), id) != 0) {
            continue;
        }
        const group* entry = ::getgrgid(id);
        const QByteArray groupName = entry ? entry->gr_name : "";
        if (groupName != name && groupName != "root") {
            QCOMPARE(writableByOthers(folder.path()), QFileInfo(folder.path()).canonicalFilePath());
        } else if (entry->gr_mem[0] == nullptr && id == user->pw_gid) {
            QCOMPARE(writableByOthers(folder.path()), QString());
        }
    }
#endif
}

QTEST_GUILESS_MAIN(SolverRegistryTest)
#include "SolverRegistryTest.moc"

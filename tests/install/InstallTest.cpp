// Checks an installed tree. It must run from any folder, print, and have completions and manual
// pages. A solver must build against it with find_package(Dipwright).
#include "PrivateCups.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

class InstallTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void install_tree_holdsAllFiles();
    void install_textFiles_nameNoBuildFolder();
    void installedCli_solvers_areFound();
    void installedCli_profiles_areFound();
    void installedProgram_samples_areFound();
    void installedCli_run_dipsSample();
    void installedCli_print_sheetArrives();
#ifdef DIPWRIGHT_MODULE_PYTHON
    void installedModule_run_dipsSample();
#endif
    void installedBinaries_rpath_namesNoBuildFolder();
    void bashCompletion_typedWords_offersMatches_data();
    void bashCompletion_typedWords_offersMatches();
    void manPage_everyCommand_isDescribed();
    void completions_zshAndFish_areValid();
#ifdef DIPWRIGHT_HAS_WORKBENCH
    void installedWorkbench_version_isPrinted();
#endif
    void findPackage_examplePlugin_buildsAndDips_data();
    void findPackage_examplePlugin_buildsAndDips();

private:
    QString installed(const QString& path) const {
        return tree_ + QLatin1Char('/') + path;
    }
    QByteArray runInstalled(const QString& program, const QStringList& arguments,
                            const QString& pluginFolder = {}) const;
    // Returns the programs and modules in the tree.
    QStringList binaries() const;
    QJsonObject listedSolver(const QString& id, const QString& pluginFolder = {}) const;

    QTemporaryDir folder_;
    QString tree_;
};

namespace {

// Returns the output of a program, or its errors if it fails.
QByteArray outputOf(const QString& program, const QStringList& arguments,
                    const QProcessEnvironment& environment) {
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    process.waitForFinished(-1);
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0) {
        return process.readAllStandardOutput();
    }
    return "failed: " + process.errorString().toUtf8() + '\n' + process.readAllStandardOutput() +
           process.readAllStandardError();
}

QByteArray runCMake(const QStringList& arguments) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DESTDIR"));
    return outputOf(QStringLiteral(DIPWRIGHT_CMAKE), arguments, environment);
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

// Runs a program without the session's environment, so that it cannot find files of the build. Its
// home folder is empty, so it does not see the user's plugins and profiles. Options for sanitizers
// and the test's print system are passed on.
QByteArray InstallTest::runInstalled(const QString& program, const QStringList& arguments,
                                     const QString& pluginFolder) const {
    QProcessEnvironment environment;
    environment.insert(QStringLiteral("HOME"), folder_.filePath("home"));
    for (const char* passed : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "CUPS_SERVER"}) {
        if (qEnvironmentVariableIsSet(passed)) {
            environment.insert(QLatin1String(passed), qEnvironmentVariable(passed));
        }
    }
    if (!pluginFolder.isEmpty()) {
        environment.insert(QStringLiteral("DIPWRIGHT_PLUGIN_PATH"), pluginFolder);
    }
    return outputOf(installed(QStringLiteral(INSTALLED_BIN "/") + program), arguments, environment);
}

QJsonObject InstallTest::listedSolver(const QString& id, const QString& pluginFolder) const {
    const QByteArray output = runInstalled("dipwright-cli", {"solvers", "--json"}, pluginFolder);
    for (const auto& entry : QJsonDocument::fromJson(output).array()) {
        if (entry.toObject().value("id") == id) {
            return entry.toObject();
        }
    }
    qWarning("%s", output.constData());
    return {};
}

// Installs into one folder and then moves the tree to another.
void InstallTest::initTestCase() {
    QVERIFY(folder_.isValid());
    const QString first = folder_.filePath("first");
    const QByteArray output = runCMake({"--install", DIPWRIGHT_BUILD_FOLDER, "--prefix", first,
                                        "--config", DIPWRIGHT_CONFIGURATION});
    QVERIFY2(QFileInfo::exists(first + "/" INSTALLED_BIN), output.constData());
    QVERIFY(QDir(folder_.path()).mkpath("home"));
    tree_ = QDir(folder_.path()).canonicalPath() + QStringLiteral("/moved elsewhere");
    QVERIFY(QDir().rename(first, tree_));
}

void InstallTest::install_tree_holdsAllFiles() {
    QStringList parts{INSTALLED_PLUGINS "/pbd-cpu.json",
                      INSTALLED_SAMPLES "/turtle.dipw",
                      INSTALLED_SAMPLES "/models/turtle.obj",
                      INSTALLED_SAMPLES "/models/turtle.mtl",
                      INSTALLED_SAMPLES "/models/turtle.png",
                      INSTALLED_INCLUDE "/dipwright/FilmSolver.h",
                      INSTALLED_PACKAGE "/DipwrightConfig.cmake",
                      INSTALLED_PACKAGE "/DipwrightConfigVersion.cmake",
                      INSTALLED_PACKAGE "/DipwrightTargets.cmake",
                      INSTALLED_DOC "/LICENSE",
                      INSTALLED_DOC "/README.md",
                      INSTALLED_DOC "/CHANGELOG.md",
                      INSTALLED_DOC "/SECURITY.md",
                      INSTALLED_DOC "/docs/examples/plumb-film/PlumbFilm.cpp"};
#ifdef Q_OS_UNIX
    parts += QStringList{INSTALLED_DATA "/man/man1/dipwright-cli.1", INSTALLED_BASH_COMPLETION,
                         INSTALLED_DATA "/zsh/vendor-completions/_dipwright-cli",
                         INSTALLED_DATA "/fish/vendor_completions.d/dipwright-cli.fish"};
#endif
#if defined DIPWRIGHT_HAS_WORKBENCH && defined Q_OS_LINUX
    parts += QStringList{INSTALLED_DATA "/applications/dipwright.desktop",
                         INSTALLED_DATA "/mime/packages/dipwright.xml",
                         INSTALLED_DATA "/metainfo/org.dipwright.Dipwright.metainfo.xml",
                         INSTALLED_DATA "/icons/hicolor/scalable/apps/dipwright.svg",
                         INSTALLED_DATA "/man/man1/dipwright.1"};
#endif
    for (const QString& part : parts) {
        QVERIFY2(QFileInfo(installed(part)).isFile(), qPrintable(part));
    }
}

void InstallTest::install_textFiles_nameNoBuildFolder() {
    QDirIterator walk(tree_, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString file = walk.next();
        if (binaries().contains(file)) {
            continue; // skips debug information, which contains the names of sources
        }
        const QByteArray text = contents(file);
        for (const QByteArray& place :
             {QByteArray(DIPWRIGHT_SOURCE_FOLDER), QByteArray(DIPWRIGHT_BUILD_FOLDER),
              folder_.filePath("first").toUtf8()}) {
            QVERIFY2(!text.contains(place), qPrintable(file));
        }
    }
}

void InstallTest::installedCli_solvers_areFound() {
    const QJsonObject solver = listedSolver(QStringLiteral("pbd-cpu"));
    QVERIFY(solver.value("available").toBool());
}

void InstallTest::installedCli_profiles_areFound() {
    const QByteArray output = runInstalled("dipwright-cli", {"profile", "list"});
    for (const char* kind : {"printer", "film", "tank"}) {
        QVERIFY2(output.contains(kind), output.constData());
    }
}

void InstallTest::installedProgram_samples_areFound() {
    QVERIFY(QFile::copy(DIPWRIGHT_LIST_SAMPLES, installed(INSTALLED_BIN "/list_samples")));
    const QString found = QString::fromUtf8(runInstalled("list_samples", {}));
    QStringList expected;
    for (const char* name : {"sphere", "tetrahedron", "turtle"}) {
        expected << installed(QStringLiteral(INSTALLED_SAMPLES "/%1.dipw").arg(name));
    }
    QCOMPARE(found.split(QLatin1Char('\n'), Qt::SkipEmptyParts), expected);
}

void InstallTest::installedCli_run_dipsSample() {
    const QString out = folder_.filePath("sphere");
    const QByteArray output =
        runInstalled("dipwright-cli",
                     {"run", installed(INSTALLED_SAMPLES "/sphere.dipw"), "--out", out, "--solver",
                      "pbd-cpu", "--set", "film.points=110x154", "--dpi", "72", "--quiet"});
    QVERIFY2(QFileInfo(out + "/immersion-1/sheet.pdf").size() > 0, output.constData());
    const QJsonObject report =
        QJsonDocument::fromJson(contents(out + QStringLiteral("/report.json"))).object();
    QVERIFY(report.value("coverage_total").toDouble() > 0.3);
}

// Prints on the test's own printer, as `print` does in a terminal.
void InstallTest::installedCli_print_sheetArrives() {
    dipwright::PrivateCups cups;
    QVERIFY2(cups.problem().isEmpty(), qPrintable(cups.problem()));
    QVERIFY(cups.add(dipwright::TestPrinter{"office"}));
    const QByteArray output =
        runInstalled("dipwright-cli",
                     {"print", installed(INSTALLED_SAMPLES "/sphere.dipw"), "--printer", "office",
                      "--set", "film.points=40x40", "--set", "sheet.paper=A4", "--quiet"});
    QTRY_VERIFY2_WITH_TIMEOUT(cups.received("office").size() == 1, output.constData(), 60000);
    QVERIFY(contents(cups.received("office").front()).startsWith("%PDF-"));
}

QStringList InstallTest::binaries() const {
    QStringList found;
    QDirIterator walk(tree_, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString file = walk.next();
        QFile opened(file);
        if (opened.open(QIODevice::ReadOnly) && opened.peek(4) == "\x7f"
                                                                  "ELF") {
            found << file;
        }
    }
    return found;
}

#ifdef DIPWRIGHT_MODULE_PYTHON
// Python finds the tree's own programs, plugins and samples.
void InstallTest::installedModule_run_dipsSample() {
    QProcessEnvironment environment;
    environment.insert(QStringLiteral("HOME"), folder_.filePath("home"));
    environment.insert(QStringLiteral("PYTHONPATH"), installed(INSTALLED_PYTHON));
    environment.insert(QStringLiteral("PYTHONDONTWRITEBYTECODE"), QStringLiteral("1"));
    const QString script =
        QStringLiteral("import dipwright, numpy\n"
                       "job = dipwright.open([name for name in dipwright.samples()"
                       " if 'sphere' in name][0])\n"
                       "assert job.path.startswith('%1'), job.path\n"
                       "job.update({'film.points': '24x32', 'sheet.dpi': 40})\n"
                       "print(job.run(certainty=False).immersions[0].film.positions.shape)\n"
                       "dipwright.new('%1/" INSTALLED_SAMPLES "/models/turtle.obj', size_mm=50)\n")
            .arg(tree_);
    const QByteArray output =
        outputOf(QStringLiteral(DIPWRIGHT_MODULE_PYTHON), {"-c", script}, environment);
    QCOMPARE(output.trimmed(), QByteArray("(768, 3)"));
}
#endif

// Programs use the system's libraries, not the build's. A GPU module must not link the driver. Then
// it can be listed on a machine without a driver, with the reason why it cannot run.
void InstallTest::installedBinaries_rpath_namesNoBuildFolder() {
    const QRegularExpression path(QStringLiteral("\\((?:RPATH|RUNPATH)\\).*\\[(.*)\\]"));
    for (const QString& binary : binaries()) {
        const QString dynamic =
            QString::fromUtf8(outputOf(QStringLiteral("readelf"), {"--dynamic", binary},
                                       QProcessEnvironment::systemEnvironment()));
        QVERIFY2(dynamic.contains(QLatin1String("NEEDED")), qPrintable(dynamic));
        QVERIFY2(!dynamic.contains(QLatin1String("libcuda")), qPrintable(binary));
        QVERIFY2(!path.match(dynamic).captured(1).contains(QLatin1String(DIPWRIGHT_BUILD_FOLDER)),
                 qPrintable(binary));
    }
}

void InstallTest::bashCompletion_typedWords_offersMatches_data() {
    QTest::addColumn<QStringList>("typed");
    QTest::addColumn<QStringList>("offered");
    QTest::newRow("a command") << QStringList{"ru"} << QStringList{"run"};
    QTest::newRow("an option") << QStringList{"run", "job.dipw", "--ou"}
                               << QStringList{"--out", "--outputs"};
    QTest::newRow("a project") << QStringList{"info", "jo"} << QStringList{"job.dipw"};
    QTest::newRow("a folder, not a file")
        << QStringList{"run", "job.dipw", "--out", "r"} << QStringList{"results"};
    QTest::newRow("after an equals sign")
        << QStringList{"run", "job.dipw", "--out", "=", "r"} << QStringList{"results"};
    QTest::newRow("a word or a file")
        << QStringList{"run", "--film-image", ""}
        << QStringList{"chessboard", "job.dipw", "readme.txt", "results"};
    QTest::newRow("one of two words")
        << QStringList{"optimize", "--immersions", ""} << QStringList{"1", "2"};
    QTest::newRow("a subcommand of profile")
        << QStringList{"profile", "s"} << QStringList{"set", "show"};
    QTest::newRow("a number") << QStringList{"run", "--threads", ""} << QStringList{};
}

void InstallTest::bashCompletion_typedWords_offersMatches() {
    QFETCH(QStringList, typed);
    QFETCH(QStringList, offered);
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("results"));
    for (const char* name : {"job.dipw", "readme.txt"}) {
        QVERIFY(QFile(folder.filePath(name)).open(QIODevice::WriteOnly));
    }
    const QString script =
        QStringLiteral("cd \"$1\"; source \"$2\"; shift 2; COMP_WORDS=(dipwright-cli \"$@\"); "
                       "COMP_CWORD=$#; _dipwright_cli; printf '%s\\n' \"${COMPREPLY[@]}\"");
    const QByteArray output =
        outputOf(QStringLiteral("bash"),
                 QStringList{"--norc", "-c", script, "bash", folder.path(),
                             installed(QStringLiteral(INSTALLED_BASH_COMPLETION))} +
                     typed,
                 QProcessEnvironment::systemEnvironment());
    QStringList found = QString::fromUtf8(output).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    found.sort();
    QCOMPARE(found, offered);
}

void InstallTest::manPage_everyCommand_isDescribed() {
    const QByteArray page = contents(installed(INSTALLED_DATA "/man/man1/dipwright-cli.1"));
    const QString help = QString::fromUtf8(runInstalled("dipwright-cli", {"--help"}));
    const QString list = help.section(QStringLiteral("Commands:\n"), 1).section("\n\n", 0, 0);
    const QStringList lines = list.split(QLatin1Char('\n'));
    QVERIFY(lines.size() > 8);
    for (const QString& line : lines) {
        const QByteArray name = line.simplified().section(QLatin1Char(' '), 0, 0).toUtf8();
        QVERIFY2(page.contains("\n.SS " + name + '\n'), name.constData());
    }
    QVERIFY(page.contains("\\fB\\-\\-film\\-image\\fR"));
    QVERIFY(page.contains(
        "Dipwright " + runInstalled("dipwright-cli", {"--version"}).trimmed().split(' ').last()));
}

// Skips shells that are not installed.
void InstallTest::completions_zshAndFish_areValid() {
    for (const auto& [shell, script] :
         {std::pair{"zsh", "/zsh/vendor-completions/_dipwright-cli"},
          std::pair{"fish", "/fish/vendor_completions.d/dipwright-cli.fish"}}) {
        if (!QStandardPaths::findExecutable(QLatin1String(shell)).isEmpty()) {
            QCOMPARE(
                outputOf(QLatin1String(shell),
                         {"-n", installed(QLatin1String(INSTALLED_DATA) + QLatin1String(script))},
                         QProcessEnvironment::systemEnvironment()),
                QByteArray());
        }
    }
}

#ifdef DIPWRIGHT_HAS_WORKBENCH
void InstallTest::installedWorkbench_version_isPrinted() {
    const QByteArray output = runInstalled("dipwright", {"-platform", "offscreen", "--version"});
    QVERIFY2(output.startsWith("dipwright "), output.constData());
}
#endif

void InstallTest::findPackage_examplePlugin_buildsAndDips_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QString>("dipwright");
    QTest::newRow("against the installed tree")
        << installed(INSTALLED_DOC "/docs/examples/plumb-film") << tree_;
    QTest::newRow("against the build")
        << QStringLiteral(DIPWRIGHT_SOURCE_FOLDER "/docs/examples/plumb-film")
        << QStringLiteral(DIPWRIGHT_BUILD_FOLDER);
}

// Builds the example plugin of the README outside the tree, finds it and dips with it.
void InstallTest::findPackage_examplePlugin_buildsAndDips() {
    QFETCH(QString, example);
    QFETCH(QString, dipwright);
    const QTemporaryDir plugin;
    QByteArray output =
        runCMake({"-S", example, "-B", plugin.path(), "-G", DIPWRIGHT_GENERATOR,
                  "-DCMAKE_CXX_COMPILER=" DIPWRIGHT_COMPILER, "-DCMAKE_PREFIX_PATH=" + dipwright});
    output += runCMake({"--build", plugin.path()});
    QVERIFY2(QFileInfo::exists(plugin.filePath("plumb-film.json")), output.constData());
    QVERIFY2(listedSolver("plumb-film", plugin.path()).value("available").toBool(),
             output.constData());

    const QString out = plugin.filePath("out");
    output =
        runInstalled("dipwright-cli",
                     {"run", installed(INSTALLED_SAMPLES "/sphere.dipw"), "--out", out, "--solver",
                      "plumb-film", "--set", "film.points=110x154", "--dpi", "72", "--quiet"},
                     plugin.path());
    const QJsonObject report =
        QJsonDocument::fromJson(contents(out + QStringLiteral("/report.json"))).object();
    QVERIFY2(!report.isEmpty(), output.constData());
    QCOMPARE(report.value("solver").toObject().value("id").toString(),
             QStringLiteral("plumb-film"));
    // If the film falls straight down, it paints the lower half and a little more.
    const double coverage = report.value("coverage_total").toDouble();
    QVERIFY2(coverage > 0.3 && coverage < 0.6, output.constData());
}

QTEST_GUILESS_MAIN(InstallTest)
#include "InstallTest.moc"

// The rules of the house: who includes whom, and what no file may say.
#include <QDirIterator>
#include <QRegularExpression>
#include <QtTest>

namespace {

const QDir source(QStringLiteral(DIPWRIGHT_SOURCE_FOLDER));

// One #include line of a source file.
struct Include {
    QString file;   // relative to the source folder
    QString target; // as it stands between the brackets or quotes
    bool isQuoted = false;
    QString describe() const { return file + QStringLiteral(" includes ") + target; }
};

QString textOf(const QString& file) {
    QFile input(source.filePath(file));
    return input.open(QIODevice::ReadOnly) ? QString::fromUtf8(input.readAll()) : QString();
}

QStringList filesIn(const QString& folder, const QStringList& patterns) {
    QStringList files;
    QDirIterator walk(source.filePath(folder), patterns, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        files << source.relativeFilePath(walk.next());
    }
    files.sort();
    return files;
}

std::vector<Include> includesIn(const QString& folder) {
    static const QRegularExpression line(QStringLiteral(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])"),
                                         QRegularExpression::MultilineOption);
    std::vector<Include> includes;
    for (const QString& file : filesIn(folder, {"*.h", "*.cpp", "*.cu", "*.cuh"})) {
        auto matches = line.globalMatch(textOf(file));
        while (matches.hasNext()) {
            const auto match = matches.next();
            includes.push_back({file, match.captured(2), match.captured(1) == QLatin1String("\"")});
        }
    }
    return includes;
}

// The folder that a quoted include names: "film" for "film/DippedFilm.h".
QString folderOf(const Include& include) {
    return include.isQuoted && include.target.contains(QLatin1Char('/'))
               ? include.target.section(QLatin1Char('/'), 0, 0)
               : QString();
}

bool isQt(const Include& include) {
    static const QRegularExpression name(QStringLiteral("^Q[A-Zt]"));
    return !include.isQuoted && name.match(include.target).hasMatch();
}

bool isVtk(const Include& include) {
    return include.target.startsWith(QLatin1String("vtk")) ||
           include.target.startsWith(QLatin1String("QVTK"));
}

// VTK's classes that draw or talk to a window.
bool isVtkRendering(const Include& include) {
    static const QRegularExpression name(
        QStringLiteral("^(QVTK|vtk[A-Za-z]*(Render|Actor|Mapper|Camera|Interact|OpenGL|Widget))"));
    return name.match(include.target).hasMatch();
}

// The header names of Qt Widgets, as installed, so that none is forgotten.
QSet<QString> widgetHeaders() {
    const QString folder = QStringLiteral(DIPWRIGHT_WIDGETS_HEADERS);
    const QStringList names =
        folder.isEmpty() ? QStringList() : QDir(folder).entryList(QDir::Files);
    return {names.begin(), names.end()};
}

QStringList coreFoldersInOrder() {
    static const QRegularExpression line(QStringLiteral(R"(add_subdirectory\((\w+)\))"));
    QStringList folders;
    auto matches = line.globalMatch(textOf(QStringLiteral("core/CMakeLists.txt")));
    while (matches.hasNext()) {
        folders << matches.next().captured(1);
    }
    return folders;
}

// Includes that break a rule, one a line; empty is good.
template <typename Rule>
QString offenders(const QString& folder, const Rule& isForbidden) {
    QStringList lines;
    for (const Include& include : includesIn(folder)) {
        if (isForbidden(include)) {
            lines << include.describe();
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

class HouseTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void findsTheSources();
    void solversIncludeNeitherQtNorCore();
    void pluginsIncludeSolversOnly();
    void coreIncludesNoProgram();
    void coreIncludesNoWidgets();
    void coreFoldersIncludeDownwards();
    void vtkStaysInItsFolders();
    void filesNameNoRegistry();
    void filesNameNoMachinePath();
};

void HouseTest::findsTheSources() {
    QVERIFY(coreFoldersInOrder().size() > 5);
    QVERIFY(includesIn(QStringLiteral("core")).size() > 100);
    QVERIFY(includesIn(QStringLiteral("solvers")).size() > 10);
}

void HouseTest::solversIncludeNeitherQtNorCore() {
    const QStringList core = coreFoldersInOrder();
    QCOMPARE(offenders(QStringLiteral("solvers"),
                       [&](const Include& include) {
                           return isQt(include) || isVtk(include) ||
                                  core.contains(folderOf(include));
                       }),
             QString());
}

void HouseTest::pluginsIncludeSolversOnly() {
    const QStringList core = coreFoldersInOrder();
    QCOMPARE(offenders(QStringLiteral("plugins"),
                       [&](const Include& include) {
                           return isQt(include) || isVtk(include) ||
                                  core.contains(folderOf(include));
                       }),
             QString());
}

void HouseTest::coreIncludesNoProgram() {
    QCOMPARE(offenders(QStringLiteral("core"),
                       [](const Include& include) {
                           return QStringList{"app",     "workbench", "viewport", "cli",
                                              "cpu",     "cuda",      "pbd",      "reference",
                                              "plugins", "solvers"}
                               .contains(folderOf(include));
                       }),
             QString());
}

void HouseTest::coreIncludesNoWidgets() {
    const QSet<QString> widgets = widgetHeaders();
    QCOMPARE(offenders(QStringLiteral("core"),
                       [&](const Include& include) {
                           return widgets.contains(include.target) ||
                                  include.target.startsWith(QLatin1String("QtWidgets"));
                       }),
             QString());
}

void HouseTest::coreFoldersIncludeDownwards() {
    const QStringList order = coreFoldersInOrder();
    QCOMPARE(offenders(QStringLiteral("core"),
                       [&](const Include& include) {
                           const auto own =
                               order.indexOf(include.file.section(QLatin1Char('/'), 1, 1));
                           return order.indexOf(folderOf(include)) > own;
                       }),
             QString());
}

void HouseTest::vtkStaysInItsFolders() {
    const auto lives = [](const Include& include, const char* folder) {
        return include.file.startsWith(QLatin1String(folder));
    };
    QCOMPARE(offenders(QStringLiteral("core"),
                       [&](const Include& include) {
                           return isVtkRendering(include) ||
                                  (isVtk(include) && !lives(include, "core/results/"));
                       }),
             QString());
    QCOMPARE(offenders(QStringLiteral("app"),
                       [&](const Include& include) {
                           return isVtk(include) && !lives(include, "app/viewport/");
                       }),
             QString());
}

namespace {

QStringList textFiles() {
    QStringList files;
    for (const char* folder : {"app", "core", "solvers", "plugins", "resources", "translations",
                               "tests", "scripts", "cmake", "docs", ".ci"}) {
        for (const QString& file : filesIn(QLatin1String(folder), {})) {
            if (!QStringList{"png", "dipw", "glb", "icc", "qm", "zip", "ico"}.contains(
                    QFileInfo(file).suffix())) {
                files << file;
            }
        }
    }
    files << QStringLiteral("CMakeLists.txt") << QStringLiteral("CMakePresets.json")
          << QStringLiteral("README.md");
    return files;
}

QString filesThatSay(const QRegularExpression& phrase) {
    QStringList lines;
    for (const QString& file : textFiles()) {
        const auto match = phrase.match(textOf(file));
        if (match.hasMatch()) {
            lines << file + QStringLiteral(": ") + match.captured(0);
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

void HouseTest::filesNameNoRegistry() {
    // Where packages come from is the system's affair. (In pieces, so as not to find itself.)
    const QStringList hosts{
        QStringLiteral("py") + "pi.org",     QStringLiteral("pythonhosted") + ".org",
        QStringLiteral("npm") + "js.",       QStringLiteral("crates") + ".io",
        QStringLiteral("deb.deb") + "ian",   QStringLiteral("proxy.go") + "lang",
        QStringLiteral("ruby") + "gems.org", QStringLiteral("conda") + ".org",
        QStringLiteral("docker") + ".io",    QStringLiteral("maven.") + "org"};
    QStringList patterns;
    for (const QString& host : hosts) {
        patterns << QRegularExpression::escape(host);
    }
    QCOMPARE(filesThatSay(QRegularExpression(patterns.join(QLatin1Char('|')))), QString());
}

void HouseTest::filesNameNoMachinePath() {
    const QStringList folders{QStringLiteral("wo") + "rk", QStringLiteral("ro") + "ot",
                              QStringLiteral("tm") + "p"};
    QCOMPARE(
        filesThatSay(QRegularExpression(
            QStringLiteral(R"((?<![\w.)}$*-])/(%1)/\w+)").arg(folders.join(QLatin1Char('|'))))),
        QString());
}

QTEST_GUILESS_MAIN(HouseTest)
#include "HouseTest.moc"

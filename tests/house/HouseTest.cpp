// Checks that no file of the repository has forbidden content. RoomsTest.cpp checks the includes.
#include "SourceTree.h"

#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QtTest>

class HouseTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void files_packageRegistries_areNotNamed();
    void files_machinePaths_areNotNamed();
    void documentCitations_targets_exist();
    void documentLinks_targets_exist();
    void documentPaths_targets_exist();
    void scripts_bashSyntax_isValid();
};

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

QStringList filesThatSay(const QRegularExpression& phrase) {
    QStringList lines;
    for (const QString& file : textFiles()) {
        const auto match = phrase.match(textOf(file));
        if (match.hasMatch()) {
            lines << file + QStringLiteral(": ") + match.captured(0);
        }
    }
    return lines;
}

} // namespace

void HouseTest::files_packageRegistries_areNotNamed() {
    QVERIFY(textFiles().size() > 300);
    // Packages come from the system, never from a registry that is named here. The registries'
    // names are split, so that the test does not find itself.
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
    expectNone(filesThatSay(QRegularExpression(patterns.join(QLatin1Char('|')))));
}

void HouseTest::files_machinePaths_areNotNamed() {
    const QStringList folders{QStringLiteral("wo") + "rk", QStringLiteral("ro") + "ot",
                              QStringLiteral("tm") + "p"};
    expectNone(filesThatSay(QRegularExpression(
        QStringLiteral(R"((?<![\w.)}$*-])/(%1)/\w+)").arg(folders.join(QLatin1Char('|'))))));
}

namespace {

QStringList documents() {
    return filesIn(QStringLiteral("docs"), {"*.md"}) +
           filesIn(QStringLiteral("resources/guide"), {"*.md"}) +
           QStringList{QStringLiteral("README.md")};
}

QStringList headingsOf(const QString& document) {
    static const QRegularExpression line(QStringLiteral("^#+ (.+)$"),
                                         QRegularExpression::MultilineOption);
    QStringList headings;
    for (const auto& match : line.globalMatch(textOf(document))) {
        headings << match.captured(1).trimmed();
    }
    return headings;
}

// Returns the anchor of a heading: the text after # in a link to the heading.
QString anchorOf(const QString& heading) {
    static const QRegularExpression dropped(QStringLiteral(R"([^\w\- ])"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    return heading.toLower().remove(dropped).replace(QLatin1Char(' '), QLatin1Char('-'));
}

bool hasAnchor(const QString& document, const QString& anchor) {
    const QStringList headings = headingsOf(document);
    return std::any_of(headings.begin(), headings.end(),
                       [&](const QString& heading) { return anchorOf(heading) == anchor; });
}

} // namespace

// A citation is written  docs/PAGE, "Heading"  and may continue on the next line of a comment.
// Names of files that a program reads are in quotes and are not citations.
void HouseTest::documentCitations_targets_exist() {
    static const QRegularExpression lineBreak(QStringLiteral(R"(\n\s*(//|#)?\s*)"));
    static const QRegularExpression citation(
        QStringLiteral(R"re(([\w./-]+\.md)\b(?!")(?:, "([^"]+)")?)re"));
    QStringList broken;
    for (const QString& file : textFiles()) {
        const QString text = textOf(file).replace(lineBreak, QStringLiteral(" "));
        if (text.contains(QChar(0xa7))) { // the section sign; comments must cite headings instead
            broken << file + QStringLiteral(": a section without its heading");
        }
        for (const auto& match : citation.globalMatch(text)) {
            const QString page = match.captured(1), heading = match.captured(2);
            const bool isBesideIt = QFileInfo(sourceTree().filePath(file)).dir().exists(page);
            if (!(sourceTree().exists(page) || isBesideIt) ||
                !(heading.isEmpty() || headingsOf(page).contains(heading))) {
                broken << file + QStringLiteral(": ") + match.captured();
            }
        }
    }
    expectNone(broken);
}

void HouseTest::documentLinks_targets_exist() {
    static const QRegularExpression link(QStringLiteral(R"(\]\(([^)#:\s]*)(?:#([^)\s]+))?\))"));
    QStringList broken;
    for (const QString& file : documents()) {
        for (const auto& match : link.globalMatch(textOf(file))) {
            const QString target = match.captured(1).isEmpty()
                                       ? file
                                       : QDir::cleanPath(QFileInfo(file).path() + QLatin1Char('/') +
                                                         match.captured(1));
            const QString anchor = match.captured(2);
            if (!sourceTree().exists(target) || !(anchor.isEmpty() || hasAnchor(target, anchor))) {
                broken << file + QStringLiteral(": ") + match.captured();
            }
        }
    }
    expectNone(broken);
}

// CODE and KIND in a path are placeholders.
void HouseTest::documentPaths_targets_exist() {
    static const QRegularExpression path(
        QStringLiteral("`((?:app|core|parallel|solvers|plugins|resources|translations|docs|scripts|"
                       "cmake)/[\\w./+-]+)`"));
    static const QRegularExpression placeholder(QStringLiteral("(?<![A-Z])(CODE|KIND)(?![A-Z])"));
    QStringList missing;
    for (const QString& file : documents()) {
        for (const auto& match : path.globalMatch(textOf(file))) {
            const QString name = match.captured(1);
            if (!placeholder.match(name).hasMatch() && !sourceTree().exists(name)) {
                missing << file + QStringLiteral(": ") + name;
            }
        }
    }
    expectNone(missing);
}

// A setup script that a merge has cut off would still succeed on machines that are already set up.
void HouseTest::scripts_bashSyntax_isValid() {
    const QStringList scripts = filesIn(QStringLiteral("scripts"), {QStringLiteral("*")});
    QVERIFY(scripts.size() >= 8);
    const QString shellPath = QStandardPaths::findExecutable(QStringLiteral("bash"));
    if (shellPath.isEmpty()) {
        return; // the shell is missing on this system
    }
    for (const QString& script : scripts) {
        QProcess shell;
        shell.setProcessChannelMode(QProcess::MergedChannels);
        shell.start(shellPath, {QStringLiteral("-n"), sourceTree().filePath(script)});
        QVERIFY2(shell.waitForFinished() && shell.exitCode() == 0,
                 qPrintable(script + QStringLiteral(": ") + QString::fromUtf8(shell.readAll())));
    }
}

QTEST_GUILESS_MAIN(HouseTest)
#include "HouseTest.moc"

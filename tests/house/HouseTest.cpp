// The rules of the house: what no file may say. Who may include whom is in RoomsTest.cpp.
#include "SourceTree.h"

#include <QRegularExpression>
#include <QtTest>

class HouseTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void filesNameNoRegistry();
    void filesNameNoMachinePath();
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

void HouseTest::filesNameNoRegistry() {
    QVERIFY(textFiles().size() > 300);
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
    expectNone(filesThatSay(QRegularExpression(patterns.join(QLatin1Char('|')))));
}

void HouseTest::filesNameNoMachinePath() {
    const QStringList folders{QStringLiteral("wo") + "rk", QStringLiteral("ro") + "ot",
                              QStringLiteral("tm") + "p"};
    expectNone(filesThatSay(QRegularExpression(
        QStringLiteral(R"((?<![\w.)}$*-])/(%1)/\w+)").arg(folders.join(QLatin1Char('|'))))));
}

QTEST_GUILESS_MAIN(HouseTest)
#include "HouseTest.moc"

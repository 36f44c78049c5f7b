// The plugin of the README, built from its own folder: it is found, and it dips.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

class ExamplePluginTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void isListed();
    void dipsTheSphere();
};

namespace {

QByteArray runCli(const QStringList& arguments) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DIPWRIGHT_PLUGIN_PATH"),
                       QStringLiteral(DIPWRIGHT_EXAMPLE_FOLDER));
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(DIPWRIGHT_BINARY_FOLDER "/dipwright-cli"), arguments);
    program.waitForFinished(-1);
    return program.exitCode() == 0 ? program.readAllStandardOutput()
                                   : "failed: " + program.readAllStandardError();
}

QJsonDocument fileContents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll())
                                          : QJsonDocument();
}

} // namespace

void ExamplePluginTest::isListed() {
    const QByteArray output = runCli({"solvers", "--json"});
    for (const auto& entry : QJsonDocument::fromJson(output).array()) {
        if (entry.toObject().value("id") == QLatin1String("plumb-film")) {
            QVERIFY(entry.toObject().value("available").toBool());
            return;
        }
    }
    QFAIL(output.constData());
}

void ExamplePluginTest::dipsTheSphere() {
    const QTemporaryDir folder;
    const QByteArray output =
        runCli({"run", DIPWRIGHT_SAMPLE_FOLDER "/sphere.dipw", "--out", folder.filePath("out"),
                "--solver", "plumb-film", "--dpi", "72", "--quiet"});
    const QJsonObject report = fileContents(folder.filePath("out/report.json")).object();
    QVERIFY2(!report.isEmpty(), output.constData());
    QCOMPARE(report.value("solver").toObject().value("id").toString(),
             QStringLiteral("plumb-film"));
    // Straight down, film reaches the lower half, and is continued a little beyond.
    const double coverage = report.value("coverage_total").toDouble();
    QVERIFY2(coverage > 0.3 && coverage < 0.6, output.constData());
}

QTEST_GUILESS_MAIN(ExamplePluginTest)
#include "ExamplePluginTest.moc"

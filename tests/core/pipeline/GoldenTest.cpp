// Tests that projects of every file version, written by the program of that version, still give the
// same results.

#include "TestFolders.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"
#include "project/ProjectStore.h"
#include "project/Schema.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>
#include <cmath>

using namespace dipwright;

namespace {

constexpr double allowed =
    0.02; // relative difference, because the last digits differ between systems

QJsonObject expectedOf(const QString& project) {
    QFile file(QFileInfo(project).path() + QLatin1Char('/') +
               QFileInfo(project).completeBaseName() + QStringLiteral(".json"));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}

void compare(const QString& name, double actual, const QJsonValue& expected) {
    QVERIFY2(expected.isDouble(), qPrintable(name));
    const double wanted = expected.toDouble();
    QVERIFY2(std::abs(actual - wanted) <= allowed * std::abs(wanted),
             qPrintable(QStringLiteral("%1: %2, expected %3").arg(name).arg(actual).arg(wanted)));
}

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT

private slots:
    void goldenProjects_everyVersion_hasOne();
    void runJob_goldenProject_givesTheRecordedFigures_data();
    void runJob_goldenProject_givesTheRecordedFigures();

private:
    const QDir golden_{sourceFolder("/tests/core/project/golden")};
};

void GoldenTest::goldenProjects_everyVersion_hasOne() {
    for (int version = 1; version <= projectVersion; ++version) {
        const QString name = QStringLiteral("version-%1.dipw").arg(version);
        QVERIFY2(golden_.exists(name), qPrintable(name));
    }
}

void GoldenTest::runJob_goldenProject_givesTheRecordedFigures_data() {
    QTest::addColumn<QString>("path");
    for (const QString& name : golden_.entryList({QStringLiteral("*.dipw")})) {
        QTest::newRow(qPrintable(name)) << golden_.filePath(name);
    }
}

void GoldenTest::runJob_goldenProject_givesTheRecordedFigures() {
    QFETCH(QString, path);
    const QJsonObject expected = expectedOf(path);
    Project project = loadProject(path);
    project.process.solver = QStringLiteral("pbd-cpu");
    JobOptions options;
    options.estimatesNumericalError = false;
    const JobResult result = runJob(project, SolverRegistry(), options, nullptr, {});
    const QJsonObject told = report(project, result);
    compare(QStringLiteral("coverage_total"), told["coverage_total"].toDouble(),
            expected["coverage_total"]);
    // In projects without share settings, each dip still paints every place that it reaches.
    QCOMPARE(told.contains("share"), expected.contains("share"));
    const QJsonObject share = expected["share"].toObject();
    for (const QString& key : share.keys()) {
        compare(key, told["share"].toObject()[key].toDouble(), share[key]);
    }
    const QJsonArray immersions = told["immersions"].toArray();
    const QJsonArray wanted = expected["immersions"].toArray();
    QCOMPARE(immersions.size(), wanted.size());
    for (qsizetype number = 0; number < immersions.size(); ++number) {
        const QJsonObject one = immersions[number].toObject();
        const QJsonObject other = wanted[number].toObject();
        QCOMPARE(one["name"], other["name"]);
        QCOMPARE(one["film"].toObject()["points"], other["points"]);
        compare("coverage", one["coverage"].toDouble(), other["coverage"]);
        compare("painted_area_mm2", one["painted_area_mm2"].toDouble(), other["painted_area_mm2"]);
        compare("stretch_mean", one["stretch"].toObject()["mean"].toDouble(),
                other["stretch_mean"]);
        compare("stretch_p95", one["stretch"].toObject()["p95"].toDouble(), other["stretch_p95"]);
        compare("contact", one["texture"].toObject()["contact"].toDouble(), other["contact"]);
        const QImage& sheet = result.immersions[std::size_t(number)].sheet.image;
        QCOMPARE(sheet.width(), expected["sheet_pixels"].toArray()[0].toInt());
        QCOMPARE(sheet.height(), expected["sheet_pixels"].toArray()[1].toInt());
    }
}

QTEST_MAIN(GoldenTest)
#include "GoldenTest.moc"

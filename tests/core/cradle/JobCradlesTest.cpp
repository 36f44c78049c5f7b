// Tests cradles of whole jobs. Some cases need models in ../shared, which are not in the
// repository. Without the models these cases are skipped; scripts/test counts them.
#include "pipeline/JobCradles.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "cradle/CradleFiles.h"
#include "import/trusted/ImportModel.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"

#include <QDir>
#include <QtTest>

using namespace dipwright;

namespace {

const QDir shared(sharedFolder("/data/models"));

Project turtle() {
    Project project = loadProject(sampleFolder("/turtle.dipw"));
    project.sheet.resolution = DotsPerInch(50);
    return project;
}

// Returns a project with a shared model, 90 mm long, dipped from below and from above.
Project twoDipsOf(const QString& model) {
    ImportOptions options;
    options.longestEdge = Millimetres(90);
    Project project;
    applyPreset(project, QStringLiteral("production"));
    project.model = std::make_shared<const TexturedMesh>(
        importModel(shared.filePath(model), options, {}).model);
    project.name = model.section(QLatin1Char('/'), 0, 0);
    project.immersions = {{QStringLiteral("Below"), {}, {}},
                          {QStringLiteral("Above"), {Degrees(180), Degrees(0), Degrees(0)}, {}}};
    project.sheet.resolution = DotsPerInch(50);
    return project;
}

JobResult resultOf(const Project& project) {
    static const SolverRegistry registry{QStringList{pluginFolder()}};
    JobOptions options;
    options.estimatesNumericalError = false;
    return runJob(project, registry, options, nullptr, {});
}

// Writes the cradles and the bodies in them, as they lie on the printer, to the folder in
// DIPWRIGHT_PICTURES, if it is set.
void keep(const QString& name, const JobResult& result, const std::vector<Cradle>& cradles) {
    const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
    for (std::size_t i = 0; i < cradles.size() && !folder.isEmpty(); ++i) {
        Cradle body = cradles[i];
        body.mesh = result.immersions[i].body->mesh;
        for (const auto& [suffix, one] : {std::pair("cradle", cradles[i]), {"body", body}}) {
            QFile file(QStringLiteral("%1/%2-%3-%4.stl").arg(folder, name).arg(i + 1).arg(suffix));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(cradleStl(one));
        }
    }
}

void judge(const Cradle& cradle) {
    const CradleCheck& check = cradle.check;
    QVERIFY(check.isClosed);
    QVERIFY(cradleStl(cradle).size() <= 3'000'000); // so that slicers read it in seconds
    QCOMPARE(check.parts, 1);
    QVERIFY(check.volume > 0);
    QVERIFY2(check.leastGap >= cradle.clearance - cradle.cell / 2,
             qPrintable(QStringLiteral("smallest gap %1 mm, expected the clearance of %2 mm")
                            .arg(check.leastGap)
                            .arg(cradle.clearance)));
    QVERIFY(check.comesOut);
    QVERIFY2(check.standing.tiltDegrees > 5, qPrintable(cradle.notes.join(u'\n')));
}

} // namespace

class JobCradlesTest : public QObject {
    Q_OBJECT

private slots:
    void jobCradles_bothDips_holdTheBody_data() {
        QTest::addColumn<QString>("model");
        QTest::newRow("turtle") << QString();
        if (test::isWholeRun()) {
            QTest::newRow("spot") << QStringLiteral("spot/spot_triangulated.obj");
            QTest::newRow("penguin") << QStringLiteral("penguin/penguin.obj");
        }
    }

    // The cradle of dip 1 stays away from the film. The cradle of dip 2 may touch paint only if
    // allowed, and then leaves room for padding.
    void jobCradles_bothDips_holdTheBody() {
        QFETCH(QString, model);
        if (!model.isEmpty() && !shared.exists()) {
            QSKIP("no shared models");
        }
        JobResult result = resultOf(model.isEmpty() ? turtle() : twoDipsOf(model));
        const CradleSettings& settings = result.project.cradle;
        const std::vector<Cradle> careful = jobCradles(result, {});
        QCOMPARE(careful.size(), std::size_t(2));
        judge(careful[0]);
        QVERIFY(careful[0].check.paintGap >= settings.paintDistance.value() - careful[0].cell / 2);
        QVERIFY(careful[0].check.paddedArea == 0 && careful[1].check.paddedArea == 0);
        if (careful[1].mesh.triangles.empty()) {
            QVERIFY(careful[1].notes.join(u' ').contains(QStringLiteral("cradle.on_paint")));
        } else {
            QVERIFY(careful[1].check.paintGap >=
                    settings.paintDistance.value() - careful[1].cell / 2);
        }

        result.project.cradle.onPaint = true;
        const std::vector<Cradle> padded = jobCradles(result, {});
        keep(QTest::currentDataTag(), result, padded);
        judge(padded[0]);
        judge(padded[1]);
        QVERIFY(padded[1].check.paddedArea > 100);
        QVERIFY(padded[1].notes.join(u' ').contains(QStringLiteral("felt")));
        QVERIFY(padded[1].check.paintGap >= settings.paintDistance.value() - padded[1].cell / 2);
    }
};

QTEST_MAIN(JobCradlesTest)
#include "JobCradlesTest.moc"

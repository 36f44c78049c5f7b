// Tests how much a sheet depends on the film model's assumed laws, with balls whose results are
// known.
#include "pipeline/LawChanges.h"
#include "TestFolders.h"

#include "geometry/Shapes.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"

#include <QJsonArray>
#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

constexpr double radius = 25; // mm

// Returns a project with a ball of one colour over a film of 49 × 49 points.
Project ball() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(radius, 60, 120);
    model->textureCoordinates.resize(model->mesh.triangles.size());
    model->material.resize(model->mesh.triangles.size(), 0);
    model->chart.resize(model->mesh.triangles.size(), 0);
    model->materials = {{QStringLiteral("body"), Qt::white, -1}};
    Project project;
    project.model = model;
    project.film.width = project.film.height = Millimetres(120);
    project.film.columns = project.film.rows = 49;
    project.fieldResolution = 96;
    project.sheet.resolution = DotsPerInch(72);
    return project;
}

// Returns the share of a ball's painted area that lies between the overhang angles `to` and `from`,
// in degrees. Paint ends at `from`.
double zone(double from, double to) {
    const double upper = std::sin(radians(Degrees(from))), lower = std::sin(radians(Degrees(to)));
    return (upper - lower) / (1 + upper);
}

} // namespace

class LawChangesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        whole_ = run(ball());
        Project shallow = ball();
        shallow.process.depth = Millimetres(0.8 * radius); // only faces that point down get wet
        shallow_ = run(shallow);
    }

    void lawChanges_vary20PercentWithinTheRange() {
        const LawChange& overhang = law(whole_, "process.overhang_deg");
        QCOMPARE(overhang.value, 20.0);
        QCOMPARE(overhang.less, 16.0);
        QCOMPARE(overhang.more, 24.0);
        const LawChange& gathering = law(whole_, "film.gathering_stretch");
        QCOMPARE(gathering.less, 0.67);  // 0.64 is out of range
        QVERIFY(gathering.more == 0.96); // exactly: the report shows all digits
    }

    void lawChanges_overhangOf0_variesByAShareOfTheDefault() {
        Project project = ball();
        project.process.overhang = Degrees(0);
        const ImmersionResult result = run(project);
        const LawChange& overhang = law(result, "process.overhang_deg");
        QCOMPARE(overhang.less, 0.0);
        QCOMPARE(overhang.more, 4.0); // 20 % of 20
        QVERIFY(overhang.distance.maximum > 0);
    }

    void lawChanges_filmWithoutTears_doesNotDependOnTearing() {
        for (const ImmersionResult* result : {&whole_, &shallow_}) {
            const LawChange& tearing = law(*result, "process.tear_stretch");
            QCOMPARE(tearing.distance.maximum, 0.0);
            QCOMPARE(tearing.moved + tearing.lost, 0.0);
        }
    }

    void lawChanges_bodyWithoutOverhang_doesNotDependOnOverhang() {
        for (const char* setting : {"process.overhang_deg", "film.grip_fade_deg"}) {
            const LawChange& change = law(shallow_, setting);
            QCOMPARE(change.distance.maximum, 0.0);
            QCOMPARE(change.moved + change.lost, 0.0);
        }
    }

    void lawChanges_lessOverhang_losesTheZoneAboveIt() {
        const LawChange& overhang = law(whole_, "process.overhang_deg");
        const double lost = zone(20, 16); // 5 %
        QVERIFY2(
            std::abs(overhang.lost - lost) < 0.005,
            qPrintable(QStringLiteral("share lost %1, expected %2").arg(overhang.lost).arg(lost)));
    }

    void report_lawChangesAskedFor_containsThem() {
        JobResult asked;
        asked.project = ball();
        asked.immersions = {whole_};
        const auto laws = [&] {
            return report(asked.project, asked)["immersions"]
                .toArray()[0]
                .toObject()["laws"]
                .toArray();
        };
        QCOMPARE(laws().size(), qsizetype(4));
        const QJsonObject overhang = laws()[0].toObject();
        QCOMPARE(overhang["setting"].toString(), QStringLiteral("process.overhang_deg"));
        QCOMPARE(overhang["lost"].toDouble(), law(whole_, "process.overhang_deg").lost);
        asked.immersions[0].laws.clear();
        QVERIFY(laws().isEmpty());
    }

    void lawText_hasRangeDistanceAndShares() {
        LawChange change{QStringLiteral("process.tear_stretch"), 4, 3.2, 4.8, {}, 0.031, 0.002};
        change.distance.percentile95 = 0.12;
        const QString words = lawText(change, millimetres);
        for (const char* part : {"Tearing", "3.2 to 4.8", "0.12 mm", "3.1 %", "0.2 %"}) {
            QVERIFY2(words.contains(QString::fromUtf8(part)), qPrintable(words));
        }
    }

private:
    ImmersionResult run(const Project& project) {
        JobOptions options;
        options.estimatesNumericalError = false;
        options.variesLaws = true;
        return runJob(project, registry_, options, nullptr, {}).immersions.front();
    }
    static const LawChange& law(const ImmersionResult& result, const char* setting) {
        return *std::find_if(result.laws.begin(), result.laws.end(), [&](const LawChange& change) {
            return change.setting == QLatin1String(setting);
        });
    }

    const SolverRegistry registry_{QStringList{pluginFolder()}};
    ImmersionResult whole_, shallow_;
};

QTEST_MAIN(LawChangesTest)
#include "LawChangesTest.moc"

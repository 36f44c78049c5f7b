// Tests the verdicts of a run, with one body for each verdict. Verdicts on the numerical error are
// compared with the full check.
#include "JoinedMeshes.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"
#include "pipeline/SheetNumericalError.h"

#include "geometry/Shapes.h"

#include <QJsonArray>
#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

std::shared_ptr<const TexturedMesh> modelOf(const TriangleMesh& mesh) {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = mesh;
    model->textureCoordinates.resize(mesh.triangles.size());
    model->material.resize(mesh.triangles.size(), 0);
    model->chart.resize(mesh.triangles.size(), 0);
    model->materials = {{QStringLiteral("body"), Qt::white, -1}};
    return model;
}

Project jobOf(const TriangleMesh& mesh, int points) {
    Project project;
    project.model = modelOf(mesh);
    project.film.width = project.film.height = Millimetres(120);
    project.film.columns = project.film.rows = points;
    project.fieldResolution = 96;
    project.sheet.resolution = DotsPerInch(72);
    return project;
}

Project ball(int points) {
    return jobOf(sphereMesh(25, 60, 120), points);
}

// Returns a project with a ball and a thumb at its side; the thumb touches the film first.
Project thumb() {
    return jobOf(
        test::joined(sphereMesh(20, 60, 120), ellipsoidMesh({8, 14, 8}, 60, 60), {15, -12, 0}), 73);
}

// Returns a project with a body on two round feet that are six film cells apart.
Project onTwoFeet() {
    const TriangleMesh foot = ellipsoidMesh({7, 20, 7}, 60, 60);
    const TriangleMesh feet = test::joined(test::joined({}, foot, {-12, 0, 0}), foot, {12, 0, 0});
    return jobOf(test::joined(feet, ellipsoidMesh({24, 14, 12}, 60, 60), {0, 18, 0}), 81);
}

} // namespace

class VerdictTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void verdict_sheetToPrint_movesWithinItsError() {
        const ImmersionResult result = run(ball(81));
        const DipNumericalError check = fullCheck(ball(81));
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Print it"));
        QVERIFY(isAccurateEnough(check));
        const double offBy = result.numericalError->offBy.percentile95;
        QVERIFY2(check.halfSpacing.distance.percentile95 <= offBy, qPrintable(sentences(result)));
        QVERIFY2(check.halfStep.distance.percentile95 <= offBy, qPrintable(sentences(result)));
        QVERIFY(sentences(result).contains("95 %"));
    }

    void verdict_limbMeetsBody_checkFirst() {
        const ImmersionResult result = run(thumb());
        qInfo("%s", qPrintable(sentences(result)));
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Check these places first"));
        QVERIFY(!isAccurateEnough(fullCheck(thumb())));
        qInfo("%s", qPrintable(sentences(result)));
        QVERIFY(!result.verdict.places.empty() && result.verdict.areaToCheck > 0);
        const TriangleMesh& mesh = result.body->mesh;
        const BoundingBox box = boundingBox(thumb().model->mesh);
        for (const PlaceToCheck& place : result.verdict.places) {
            QVERIFY(box.exteriorDistance(place.place) < 1); // on the model, in its own frame
            QVERIFY(place.area > 0 && place.area < surfaceArea(mesh));
        }
    }

    void verdict_filmSharedByTwoFeet_checkFirst() {
        const ImmersionResult result = run(onTwoFeet());
        qInfo("%s", qPrintable(sentences(result)));
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Check these places first"));
        if (test::isWholeRun()) { // the thumb is checked in every run
            QVERIFY(!isAccurateEnough(fullCheck(onTwoFeet())));
        }
        QVERIFY(!result.verdict.places.empty());
    }

    void verdict_farTooFewPoints_doNotPrint() {
        const ImmersionResult result = run(ball(17));
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Do not print"));
        QVERIFY(!isAccurateEnough(fullCheck(ball(17))));
    }

    void verdict_plainColour_checkFirst() {
        Project project = ball(33);
        const JobResult plain = unjudged(project);
        QCOMPARE(adviceOf(plain), Advice::CheckFirst);
        QVERIFY(has(plain, VerdictReason::Kind::NoPicture));
        QVERIFY(has(plain, VerdictReason::Kind::GuessedFilm));
        QVERIFY(!has(plain, VerdictReason::Kind::ChangedModel));
        project.verdict.noPicture = Advice::Print;
        project.modelOrigin.losses = QStringLiteral("The texture wood.png is missing");
        const JobResult incomplete = unjudged(project);
        QCOMPARE(adviceOf(incomplete), Advice::CheckFirst);
        QVERIFY(has(incomplete, VerdictReason::Kind::IncompleteModel));
        project.modelOrigin.losses.clear();
        project.verdict.guessedFilm = Advice::DoNotPrint;
        project.modelOrigin.remarks = QStringLiteral("Points that were merged: 14");
        const JobResult guessed = unjudged(project);
        QCOMPARE(adviceOf(guessed), Advice::DoNotPrint);
        QCOMPARE(reasonsOf(guessed).front().reason.kind, VerdictReason::Kind::GuessedFilm);
        QVERIFY(has(guessed, VerdictReason::Kind::ChangedModel));
        const QJsonObject json = report(project, guessed);
        QCOMPARE(json["verdict"].toString(), QStringLiteral("do_not_print"));
        const QJsonObject first = json["reasons"].toArray().first().toObject();
        QCOMPARE(first["kind"].toString(), QStringLiteral("guessed_film"));
        QCOMPARE(first["field"].toString(), QStringLiteral("verdict.guessed_film"));
        QVERIFY(QString::fromUtf8(QJsonDocument(json).toJson()).contains("merged: 14"));
    }

    void verdict_valuesFarFromUsual_checkFirst() {
        using Kind = VerdictReason::Kind;
        JobResult result = unjudged(ball(17));
        QVERIFY(!has(result, Kind::UnusualSpeed) && !has(result, Kind::UnusualGrowthRate));
        QVERIFY(!has(result, Kind::UnusualSwell));
        result.project.film.swellY = 0.55; // as measured from pages that were printed too small
        result.project.process.dipSpeed = MillimetresPerSecond(1000);
        result.project.film.growthRate = 0.9;
        result.verdict = allDipsVerdict(result, nullptr);
        QVERIFY(has(result, Kind::UnusualSpeed) && has(result, Kind::UnusualSwell));
        QVERIFY(!has(result, Kind::UnusualGrowthRate)); // without a limit the film does not grow
        result.project.process.dipSpeed = MillimetresPerSecond(0.01);
        result.project.film.growthLimit = 0.9;
        result.verdict = allDipsVerdict(result, nullptr);
        QVERIFY(has(result, Kind::UnusualSpeed));
        QVERIFY(has(result, Kind::UnusualGrowthRate) && has(result, Kind::UnusualGrowth));
        QCOMPARE(reasonText({Kind::UnusualSpeed, Advice::CheckFirst, 0.01, 0.5}, millimetres),
                 QStringLiteral(
                     "The dip speed is 0.01 mm/s; the usual range is 0.5 to 100 mm/s. Check this "
                     "value."));
    }

    void verdict_slowSpeedFarFromUsual_checkFirst() {
        using Kind = VerdictReason::Kind;
        JobResult result = unjudged(ball(17));
        const auto isUnusual = [&](PathKind kind, double speed, double way) {
            DipPath& path = result.project.immersions.front().path;
            path.kind = kind;
            path.slowSpeed = MillimetresPerSecond(speed);
            path.slowWay = Millimetres(way);
            result.verdict = allDipsVerdict(result, nullptr);
            return has(result, Kind::UnusualSlowSpeed);
        };
        QVERIFY(isUnusual(PathKind::Straight, 0.1, 5));
        QVERIFY(isUnusual(PathKind::Straight, 150, 5));
        QVERIFY(!isUnusual(PathKind::Straight, 2, 5));
        // Not used:
        QVERIFY(!isUnusual(PathKind::Straight, 0.1, 0));
        QVERIFY(!isUnusual(PathKind::Poses, 0.1, 5));
        QCOMPARE(reasonText(
                     {Kind::UnusualSlowSpeed, Advice::CheckFirst, 0.1, 0.5, QStringLiteral("Top")},
                     millimetres),
                 QStringLiteral("Top: the slow speed is 0.1 mm/s; the usual range is 0.5 to 100 "
                                "mm/s. Check this value."));
    }

    void verdict_posesFarFromUsualSpeed_checkFirst() {
        using Kind = VerdictReason::Kind;
        JobResult result = unjudged(ball(17));
        ImmersionResult& dip = result.immersions.front();
        const auto body =
            std::make_shared<PosedBody>(posedBody(result.project.model->mesh, dip.immersion));
        dip.body = body;
        const auto isUnusual = [&](double halfway, double end) {
            body->path.poses = {{0, 0}, {15, halfway}, {30, end}};
            dip.immersion.path.kind = PathKind::Poses;
            result.verdict = allDipsVerdict(result, nullptr);
            return has(result, Kind::UnusualPathSpeed);
        };
        QVERIFY(!isUnusual(3, 6));
        QVERIFY(!isUnusual(45, 50)); // waits
        QVERIFY(isUnusual(3, 100));
        QVERIFY(isUnusual(0.1, 6));
        QCOMPARE(reasonText(
                     {Kind::UnusualPathSpeed, Advice::CheckFirst, 0.1, 0.5, QStringLiteral("Top")},
                     millimetres),
                 QStringLiteral("Top: the part moves at 0.1 mm/s on its path; the usual range is "
                                "0.5 to 100 mm/s. Check the times of the poses."));
    }

    // The top of the ball lies above the overhang limit and stays bare.
    void verdict_bareMarkedZone_doNotPrint() {
        Project project = ball(33);
        project.verdict.noPicture = Advice::Print;
        QVERIFY(adviceOf(unjudged(project)) < Advice::CheckFirst);
        ZoneMark top;
        top.zone = Zone::B;
        top.place = {Millimetres(0), Millimetres(25), Millimetres(0)};
        top.radius = Millimetres(8);
        project.tolerance.marks = {top};
        const JobResult bare = unjudged(project);
        QCOMPARE(adviceOf(bare), Advice::DoNotPrint);
        QCOMPARE(reasonsOf(bare).front().reason.kind, VerdictReason::Kind::ZoneBare);
        QCOMPARE(reasonsOf(bare).front().reason.zone, std::optional(Zone::B));
    }

    void verdict_areaThatNoDipReaches_doNotPrint() {
        Project project = ball(33);
        project.verdict.noPicture = Advice::Print;
        project.immersions = {Immersion{}, Immersion{}}; // in the same pose
        project.share.enabled = false;
        const JobResult result = unjudged(project);
        QCOMPARE(adviceOf(result), Advice::DoNotPrint);
        const VerdictReason reason = reasonsOf(result).front().reason;
        QCOMPARE(reason.kind, VerdictReason::Kind::Unreached);
        QVERIFY(std::abs(reason.value - (1 - result.coverageTotal)) < 1e-9);
    }

private:
    // Runs the job without coarser dips, which these verdicts do not need.
    JobResult unjudged(const Project& project) {
        JobOptions options;
        options.estimatesNumericalError = false;
        return runJob(project, registry_, options, nullptr, {});
    }
    static bool has(const JobResult& result, VerdictReason::Kind kind) {
        return std::ranges::any_of(reasonsOf(result), [kind](const JobReason& reason) {
            return reason.reason.kind == kind;
        });
    }
    ImmersionResult run(const Project& project) {
        return runJob(project, registry_, {}, nullptr, {}).immersions.front();
    }
    DipNumericalError fullCheck(const Project& project) {
        return sheetNumericalError(project, registry_, {}).front();
    }
    static QString sentences(const ImmersionResult& result) {
        QStringList all;
        for (const VerdictReason& reason : result.verdict.reasons) {
            all.append(reasonText(reason, millimetres));
        }
        return all.join(' ');
    }

    const SolverRegistry registry_{QStringList{pluginFolder()}};
};

QTEST_MAIN(VerdictTest)
#include "VerdictTest.moc"

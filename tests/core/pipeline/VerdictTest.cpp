// What a run says of its sheets, held against the full check: a body of each kind.
#include "TestFolders.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"
#include "pipeline/SheetCertainty.h"

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

TriangleMesh joined(std::initializer_list<std::pair<TriangleMesh, Eigen::Vector3f>> parts) {
    TriangleMesh whole;
    for (const auto& [part, place] : parts) {
        const auto first = std::uint32_t(whole.positions.size());
        for (const Eigen::Vector3f& position : part.positions) {
            whole.positions.push_back(position + place);
        }
        for (const auto& [a, b, c] : part.triangles) {
            whole.triangles.push_back({first + a, first + b, first + c});
        }
    }
    return whole;
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

// A ball with a thumb at its side, which goes down first.
Project thumb() {
    return jobOf(joined({{sphereMesh(20, 60, 120), {0, 0, 0}},
                         {ellipsoidMesh({8, 14, 8}, 60, 60), {15, -12, 0}}}),
                 73);
}

// Two round feet side by side, six film cells apart, under a body.
Project onTwoFeet() {
    const TriangleMesh foot = ellipsoidMesh({7, 20, 7}, 60, 60);
    return jobOf(joined({{foot, {-12, 0, 0}},
                         {foot, {12, 0, 0}},
                         {ellipsoidMesh({24, 14, 12}, 60, 60), {0, 18, 0}}}),
                 81);
}

} // namespace

class VerdictTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void aCertainSheetMovesByNoMoreThanItSays() {
        const ImmersionResult result = run(ball(97));
        const ImmersionCertainty check = fullCheck(ball(97));
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Print it"));
        QVERIFY(isCertain(check));
        const double offBy = result.certainty->offBy.percentile95;
        QVERIFY2(check.halfSpacing.distance.percentile95 <= offBy, qPrintable(sentences(result)));
        QVERIFY2(check.halfStep.distance.percentile95 <= offBy, qPrintable(sentences(result)));
        QVERIFY(sentences(result).contains("95 %"));
    }

    void whereALimbMeetsTheBodyThereIsSomethingToLookAt() {
        const ImmersionResult result = run(thumb());
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Look at these places first"));
        QVERIFY(!isCertain(fullCheck(thumb())));
        QVERIFY(!result.verdict.places.empty() && result.verdict.uncertainArea > 0);
        const TriangleMesh& mesh = result.body->model.mesh;
        const BoundingBox box = boundingBox(thumb().model->mesh);
        for (const UncertainPlace& place : result.verdict.places) {
            QVERIFY(box.exteriorDistance(place.place) < 1); // on the model, in its own frame
            QVERIFY(place.area > 0 && place.area < surfaceArea(mesh));
        }
    }

    void filmThatTwoFeetShareIsSomethingToLookAt() {
        const ImmersionResult result = run(onTwoFeet());
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Look at these places first"));
        QVERIFY(!isCertain(fullCheck(onTwoFeet())));
        QVERIFY(!result.verdict.places.empty());
    }

    void aSheetOfFarTooFewPointsIsNotToBePrinted() {
        const ImmersionResult result = run(ball(17));
        QCOMPARE(adviceText(result.verdict.advice), QStringLiteral("Do not print"));
        QVERIFY(!isCertain(fullCheck(ball(17))));
    }

private:
    ImmersionResult run(const Project& project) {
        return runJob(project, registry_, {}, nullptr, {}).immersions.front();
    }
    ImmersionCertainty fullCheck(const Project& project) {
        return sheetCertainty(project, registry_, {}).front();
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

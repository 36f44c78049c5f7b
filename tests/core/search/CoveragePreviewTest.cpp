// Tests coverage previewed from the body's shape alone, compared with closed forms and with dips.
#include "search/CoveragePreview.h"
#include "HollowBodies.h"
#include "JoinedMeshes.h"
#include "SearchSubjects.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "dip/Coverage.h"
#include "dip/Dip.h"
#include "geometry/DistanceField.h"
#include "solver/SolverRegistry.h"

#include <QStandardPaths>
#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

Immersion turned(double x, double z) {
    Immersion immersion;
    immersion.rotation[0] = Degrees(x);
    immersion.rotation[2] = Degrees(z);
    return immersion;
}

double previewed(const SearchSubject& subject, const Immersion& immersion) {
    return CoveragePreview(subject.model->mesh).at(immersion, subject.film, subject.process).share;
}

} // namespace

class CoveragePreviewTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
    }

    void coveragePreview_ball_isPaintedUpToTheOverhang() {
        const SearchSubject subject = subjectOf(sphereMesh(20, 60, 80));
        const double wanted = (1 + std::sin(radians(subject.process.overhang))) / 2;
        QVERIFY(std::abs(previewed(subject, turned(0, 0)) - wanted) < 0.02);
        QVERIFY(std::abs(previewed(subject, turned(40, 20)) - wanted) < 0.02);
    }

    void coveragePreview_cube_isPaintedOnFiveOrThreeSides() {
        const SearchSubject subject = subjectOf(boxMesh({30, 30, 30}));
        QVERIFY(std::abs(previewed(subject, turned(0, 0)) - 5.0 / 6) < 0.01);
        QVERIFY(std::abs(previewed(subject, turned(45, 35.26)) - 0.5) < 0.01); // on its corner
    }

    void coveragePreview_boxInTheBody_doesNotCount() {
        const TriangleMesh pair = test::joined(boxMesh({30, 30, 30}), boxMesh({10, 10, 10}));
        QVERIFY(std::abs(previewed(subjectOf(pair), turned(0, 0)) - 5.0 / 6) < 0.01);
    }

    void coveragePreview_besideFilmOrAboveWater_staysBare() {
        SearchSubject subject = subjectOf(boxMesh({30, 30, 30}));
        Immersion beside;
        beside.offset[0] = Millimetres(50);
        QVERIFY(previewed(subject, beside) < 0.5);
        subject.process.depth = Millimetres(15);
        QVERIFY(std::abs(previewed(subject, turned(0, 0)) - (1 + 4 * 0.5) / 6) < 0.03);
    }

    void coveragePreview_hiddenFromBelow_staysBare() {
        // Two plates, one above the other. Film does not reach the underside and the walls of the
        // upper plate.
        const TriangleMesh plates =
            test::joined(boxMesh({30, 4, 30}), boxMesh({20, 4, 20}), {0, 20, 0});
        const double lower = 30 * 30 + 4 * 30 * 4;
        const double share = previewed(subjectOf(plates), turned(0, 0));
        QVERIFY(std::abs(share - lower / surfaceArea(plates)) < 0.01);
    }

    void coveragePreview_trappedAir_staysBare() {
        // A bowl with its rim down is painted on the rim, and on the wall up to the overhang. With
        // a hole in its top, or tilted so that the air escapes, more of the bowl is painted.
        const SearchSubject subject = subjectOf(test::bowl());
        const double rim = pi * (32 * 32 - 29 * 29);
        const double wall = 2 * pi * 32 * 32 * std::sin(radians(subject.process.overhang));
        const double whole = surfaceArea(subject.model->mesh);
        const double share = previewed(subject, turned(0, 0));
        QVERIFY2(
            std::abs(share - (rim + wall) / whole) < 0.03,
            qPrintable(
                QStringLiteral("coverage %1, expected %2").arg(share).arg((rim + wall) / whole)));
        QVERIFY(previewed(subjectOf(test::bowl(4)), turned(0, 0)) > share + 0.3);
        QVERIFY(previewed(subject, turned(90, 0)) > share + 0.1);
    }

    // A cylinder of radius 10 mm is painted where it has been up to 3 mm under water: over 91° of
    // its round surface if it goes straight down, and over 271° if it then rolls by 180°.
    void coveragePreview_roll_coversWhatGoesUnderWater() {
        SearchSubject subject = subjectOf(cylinderMesh(10, 40, 180));
        subject.process.depth = Millimetres(3);
        Immersion lying = turned(0, 0);
        const double whole = surfaceArea(subject.model->mesh);
        const double round = 2 * pi * 10 * 40;
        const double dipped = 2 * std::acos(7.0 / 10);
        const double straight = previewed(subject, lying);
        QVERIFY2(straight < dipped / (2 * pi) * round / whole + 0.1,
                 qPrintable(QStringLiteral("%1").arg(straight)));
        lying.path.kind = PathKind::Roll;
        lying.path.heading = Degrees(0);
        lying.path.angle = Degrees(180);
        const double rolled = previewed(subject, lying);
        QVERIFY2(std::abs(rolled - straight - 0.5 * round / whole) < 0.06,
                 qPrintable(QStringLiteral("%1 and %2").arg(straight).arg(rolled)));
    }

    void coveragePreview_pathThatCannotBeTravelled_coversNothing() {
        Immersion immersion;
        immersion.path.kind = PathKind::Poses;
        QCOMPARE(previewed(subjectOf(boxMesh({30, 30, 30})), immersion), 0.0);
    }

    void coveragePreview_ofModel_marksEachTriangle() {
        const SearchSubject subject = subjectOf(boxMesh({30, 30, 30}));
        const CoveragePreview preview(subject.model->mesh);
        const auto covered =
            preview.ofModel(preview.at(turned(0, 0), subject.film, subject.process));
        QCOMPARE(covered.size(), subject.model->mesh.triangles.size());
        for (std::size_t triangle = 0; triangle < covered.size(); ++triangle) {
            const bool isTop = triangleNormal(subject.model->mesh, triangle).y() > 0.5f;
            QCOMPARE(covered[triangle] != 0, !isTop);
        }
    }

    void coveragePreview_agreesWithDips_data() {
        QTest::addColumn<int>("body");
        QTest::addColumn<double>("about");
        QTest::newRow("egg, tilted") << 1 << 50.0;
        QTest::newRow("tetrahedron, tilted") << 3 << 70.0;
        QTest::newRow("ring, tilted") << 2 << 35.0;
        if (test::isWholeRun()) {
            QTest::newRow("ball") << 0 << 0.0;
            QTest::newRow("ring, flat") << 2 << 0.0;
            QTest::newRow("tetrahedron, flat") << 3 << 0.0;
            QTest::newRow("tetrahedron, tilted less") << 3 << 20.0;
            QTest::newRow("cylinder, tilted") << 4 << 40.0;
        }
    }
    void coveragePreview_agreesWithDips() {
        QFETCH(int, body);
        QFETCH(double, about);
        const std::array<TriangleMesh, 5> meshes{
            sphereMesh(20, 40, 60), ellipsoidMesh({15, 25, 12}, 40, 60), torusMesh(18, 6, 60, 24),
            tetrahedronMesh(40), cylinderMesh(10, 40, 60)};
        const SearchSubject subject = subjectOf(meshes[std::size_t(body)]);
        const Immersion immersion = turned(about, about / 2);
        const auto posed =
            std::make_shared<const PosedBody>(posedBody(subject.model->mesh, immersion));
        const auto field = cachedDistanceField(subject.model->mesh, subject.fieldResolution, {});
        const auto laid = layFilm(posed,
                                  simulateDip(*posed, *field, immersion, subject.film,
                                              subject.process, registry_->module("auto"), {}, {}),
                                  subject.process);
        const double dipped = coverage(*laid).share;
        const double share = previewed(subject, immersion);
        QVERIFY2(std::abs(share - dipped) < 0.06,
                 qPrintable(QStringLiteral("previewed coverage %1, dipped %2; expected within 0.06")
                                .arg(share)
                                .arg(dipped)));
    }

private:
    std::unique_ptr<SolverRegistry> registry_;
};

QTEST_GUILESS_MAIN(CoveragePreviewTest)
#include "CoveragePreviewTest.moc"

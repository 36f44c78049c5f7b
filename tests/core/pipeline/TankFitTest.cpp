// Tests the limits of a tank and its machine.
#include "pipeline/TankFit.h"

#include "dip/Pose.h"
#include "geometry/Shapes.h"
#include "model/TexturedMesh.h"
#include "project/Project.h"

#include <QTest>

using namespace dipwright;

namespace {

// A box of 40 × 20 × 30 mm over a large film, in a tank without limits.
Project boxInTank() {
    Project project;
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = boxMesh({40, 20, 30});
    project.model = model;
    project.immersions.resize(1);
    project.process.depth = Millimetres(20);
    project.process.dipSpeed = MillimetresPerSecond(5);
    TankProfile tank;
    tank.name = QStringLiteral("Bath");
    tank.width = Millimetres(400);
    tank.length = Millimetres(600);
    project.profiles.tank = tank;
    return project;
}

QString faults(const Project& project) {
    const Immersion& immersion = project.immersions.front();
    const TriangleMesh& mesh = project.model->mesh;
    const TriangleMesh posed = transformed(mesh, poseTransform(mesh, immersion));
    return tankFaults(project, immersion, posed, bodyPath(posed, immersion, project.process))
        .join(u'\n');
}

} // namespace

class TankFitTest : public QObject {
    Q_OBJECT

private slots:
    void tankFaults_withoutLimits_areNone() {
        Project project = boxInTank();
        QCOMPARE(faults(project), QString());
        project.profiles.tank->width = Millimetres(30);
        QVERIFY(faults(project).contains(QStringLiteral("past the edge of the tank “Bath”")));
        project.profiles.tank.reset();
        QCOMPARE(faults(project), QString());
    }

    void tankFaults_straightDip_comparesDepthReachAndSpeed() {
        Project project = boxInTank();
        TankProfile& tank = *project.profiles.tank;
        project.immersions.front().offset = {Millimetres(30), Millimetres(-40)};
        tank.waterDepth = Millimetres(20);
        tank.reach = Millimetres(50);
        tank.speed = MillimetresPerSecond(5);
        QCOMPARE(faults(project), QString());
        tank.waterDepth = Millimetres(19);
        QVERIFY(faults(project).contains(QStringLiteral("goes 20.0 mm under water")));
        tank.waterDepth.reset();
        tank.reach = Millimetres(49);
        QVERIFY(faults(project).contains(QStringLiteral("moves 50.0 mm sideways")));
        tank.reach.reset();
        tank.speed = MillimetresPerSecond(4);
        QVERIFY(faults(project).contains(QStringLiteral("moves at up to 5.0 mm/s")));
    }

    // A box that turns by 90° about the vertical, in 20.5 mm of its way down at 5 mm/s.
    void tankFaults_turningPart_comparesTheTurn() {
        Project project = boxInTank();
        project.immersions.front().path.turn = Degrees(90);
        project.profiles.tank->turnSpeed = DegreesPerSecond(22.5);
        QCOMPARE(faults(project), QString());
        project.profiles.tank->turnSpeed = DegreesPerSecond(20);
        QVERIFY2(faults(project).contains(QStringLiteral("turns at up to 2")),
                 qPrintable(faults(project)));
    }

    // From 0.5 mm above the water to a depth of 20 mm, at 45°.
    void tankFaults_slantedDip_comparesTheSidewaysTravel() {
        Project project = boxInTank();
        project.immersions.front().path.kind = PathKind::Slanted;
        project.immersions.front().path.angle = Degrees(45);
        project.profiles.tank->reach = Millimetres(19);
        QVERIFY2(faults(project).contains(QStringLiteral("moves 20.5 mm sideways")),
                 qPrintable(faults(project)));
        project.profiles.tank->reach = Millimetres(21);
        QCOMPARE(faults(project), QString());
    }

    // The film flows as fast as the part travels sideways. So the part goes straight down through
    // the film, but the machine moves it sideways.
    void tankFaults_flowingWater_comparesTheMachinesMotion() {
        Project project = boxInTank();
        DipPath& path = project.immersions.front().path;
        path.kind = PathKind::Slanted;
        path.angle = Degrees(45);
        path.waterSpeed = MillimetresPerSecond(5); // as fast as the dip, which takes 4.1 s
        project.profiles.tank->reach = Millimetres(20);
        project.profiles.tank->speed = MillimetresPerSecond(7);
        const QString found = faults(project);
        QVERIFY2(found.contains(QStringLiteral("moves 20.5 mm sideways")), qPrintable(found));
        QVERIFY2(found.contains(QStringLiteral("moves at up to 7.1 mm/s")), qPrintable(found));
    }

    // A box that enters tilted covers more of the water until it is level.
    void tankFaults_tiltedEntry_comparesTheWholePath() {
        Project project = boxInTank();
        project.profiles.tank->width = Millimetres(41);
        QCOMPARE(faults(project), QString());
        project.immersions.front().path.kind = PathKind::Tilt;
        project.immersions.front().path.angle = Degrees(20);
        QVERIFY(faults(project).contains(QStringLiteral("past the edge of the tank")));
    }
};

QTEST_GUILESS_MAIN(TankFitTest)
#include "TankFitTest.moc"

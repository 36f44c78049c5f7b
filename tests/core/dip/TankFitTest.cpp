// Tests the limits of a tank and its machine.
#include "dip/TankFit.h"

#include "dip/Pose.h"
#include "geometry/Shapes.h"

#include <QTest>

using namespace dipwright;

namespace {

struct TankDip {
    FilmSettings film;
    ProcessSettings process;
    Immersion immersion;
    std::optional<TankProfile> tank;
};

// A box of 40 × 20 × 30 mm over a large film, in a tank without limits.
TankDip boxInTank() {
    TankDip dip;
    dip.process.depth = Millimetres(20);
    dip.process.dipSpeed = MillimetresPerSecond(5);
    TankProfile tank;
    tank.name = QStringLiteral("Bath");
    tank.width = Millimetres(400);
    tank.length = Millimetres(600);
    dip.tank = tank;
    return dip;
}

std::vector<TankFault> faultsOf(const TankDip& dip,
                                const TriangleMesh& mesh = boxMesh({40, 20, 30})) {
    const TriangleMesh posed = transformed(mesh, poseTransform(mesh, dip.immersion));
    return tankFaults(dip.tank, dip.film, dip.process, dip.immersion, posed,
                      bodyPath(posed, dip.immersion, dip.process));
}

QString faults(const TankDip& dip) {
    return textOf(faultsOf(dip));
}

} // namespace

class TankFitTest : public QObject {
    Q_OBJECT

private slots:
    void tankFaults_withoutLimits_areNone() {
        TankDip dip = boxInTank();
        QCOMPARE(faults(dip), QString());
        dip.tank->width = Millimetres(30);
        QVERIFY(faults(dip).contains(QStringLiteral("past the edge of the tank “Bath”")));
        dip.tank.reset();
        QCOMPARE(faults(dip), QString());
    }

    // The film swells on the water: by 10 % in width and 20 % in height.
    void tankFaults_filmLargerThanTheTank_areTold() {
        TankDip dip = boxInTank();
        dip.film.width = Millimetres(360);
        dip.film.height = Millimetres(500);
        dip.film.swellX = 1.1;
        dip.film.swellY = 1.2;
        QCOMPARE(faults(dip), QString());
        dip.film.width = Millimetres(370);
        QVERIFY2(
            faults(dip).contains(QStringLiteral("film measures 407.0 × 600.0 mm on the water")),
            qPrintable(faults(dip)));
        QCOMPARE(faultsOf(dip).front().value, 407.0);
        QCOMPARE(faultsOf(dip).front().limit, 400.0);
        dip.film.height = Millimetres(600);
        QCOMPARE(faultsOf(dip).front().value, 720.0);
        QCOMPARE(faultsOf(dip).front().limit, 600.0);
    }

    void tankFaults_straightDip_comparesDepthReachAndSpeed() {
        TankDip dip = boxInTank();
        TankProfile& tank = *dip.tank;
        dip.immersion.offset = {Millimetres(30), Millimetres(-40)};
        tank.waterDepth = Millimetres(20);
        tank.reach = Millimetres(50);
        tank.speed = MillimetresPerSecond(5);
        QCOMPARE(faults(dip), QString());
        tank.waterDepth = Millimetres(19);
        QVERIFY(faults(dip).contains(QStringLiteral("goes 20.0 mm under water")));
        tank.waterDepth.reset();
        tank.reach = Millimetres(49);
        QVERIFY(faults(dip).contains(QStringLiteral("moves 50.0 mm sideways")));
        tank.reach.reset();
        tank.speed = MillimetresPerSecond(4);
        QVERIFY(faults(dip).contains(QStringLiteral("moves at up to 5.0 mm/s")));
    }

    // A box that turns by 90° about the vertical, in 20.5 mm of its way down at 5 mm/s.
    void tankFaults_turningPart_comparesTheTurn() {
        TankDip dip = boxInTank();
        dip.immersion.path.turn = Degrees(90);
        dip.tank->turnSpeed = DegreesPerSecond(22.5);
        QCOMPARE(faults(dip), QString());
        dip.tank->turnSpeed = DegreesPerSecond(20);
        QVERIFY2(faults(dip).contains(QStringLiteral("turns at up to 2")), qPrintable(faults(dip)));
    }

    // From 0.5 mm above the water to a depth of 20 mm, at 45°.
    void tankFaults_slantedDip_comparesTheSidewaysTravel() {
        TankDip dip = boxInTank();
        dip.immersion.path.kind = PathKind::Slanted;
        dip.immersion.path.angle = Degrees(45);
        dip.tank->reach = Millimetres(19);
        QVERIFY2(faults(dip).contains(QStringLiteral("moves 20.5 mm sideways")),
                 qPrintable(faults(dip)));
        dip.tank->reach = Millimetres(21);
        QCOMPARE(faults(dip), QString());
    }

    // The film flows as fast as the part travels sideways. So the part goes straight down through
    // the film, but the machine moves it sideways.
    void tankFaults_flowingWater_comparesTheMachinesMotion() {
        TankDip dip = boxInTank();
        DipPath& path = dip.immersion.path;
        path.kind = PathKind::Slanted;
        path.angle = Degrees(45);
        path.waterSpeed = MillimetresPerSecond(5); // as fast as the dip, which takes 4.1 s
        dip.tank->reach = Millimetres(20);
        dip.tank->speed = MillimetresPerSecond(7);
        const QString found = faults(dip);
        QVERIFY2(found.contains(QStringLiteral("moves 20.5 mm sideways")), qPrintable(found));
        QVERIFY2(found.contains(QStringLiteral("moves at up to 7.1 mm/s")), qPrintable(found));
    }

    // The film is carried on for the 4.1 s of the dip.
    void tankFaults_flowingWater_comparesWhereTheFilmEnds() {
        TankDip dip = boxInTank();
        dip.tank->width = dip.film.width + Millimetres(2 * 20);
        dip.immersion.path.waterSpeed = MillimetresPerSecond(4);
        QCOMPARE(faults(dip), QString());
        dip.immersion.path.waterSpeed = MillimetresPerSecond(6);
        QVERIFY2(faults(dip).contains(QStringLiteral("carries the film 24.6 mm")),
                 qPrintable(faults(dip)));
    }

    // The part travels 27 mm sideways before it is under water.
    void tankFaults_partReachesPastABarrier_isTold() {
        TankDip dip = boxInTank();
        dip.tank.reset();
        dip.film.width = Millimetres(80);
        dip.film.edges.rightPinned = true;
        QCOMPARE(faults(dip), QString());
        dip.immersion.path.kind = PathKind::Slanted;
        dip.immersion.path.angle = Degrees(36);
        QVERIFY2(faults(dip).contains(QStringLiteral("past the barrier at the film's right edge")),
                 qPrintable(faults(dip)));
        dip.film.edges = {true, false, true, true};
        QCOMPARE(faults(dip), QString());
        dip.immersion.path = {};
        dip.immersion.offset[0] = Millimetres(-21);
        QVERIFY(faults(dip).contains(QStringLiteral("past the barrier at the film's left edge")));
    }

    // The cone's only point under water is its tip; at the water it is 50 mm wide.
    void tankFaults_fewLargeTriangles_areCutAtTheWater() {
        TankDip dip = boxInTank();
        dip.tank.reset();
        dip.process.depth = Millimetres(25);
        dip.film.edges.leftPinned = true;
        dip.film.swellX = 1;
        dip.film.width = Millimetres(48);
        const TriangleMesh cone = coneMesh(pi / 4, 60, 8);
        QVERIFY(!faultsOf(dip, cone).empty());
        dip.film.width = Millimetres(52);
        QVERIFY(faultsOf(dip, cone).empty());
    }

    void tankFaults_valueJustAboveTheLimit_showsTheDifference() {
        TankDip dip = boxInTank();
        dip.process.dipSpeed = MillimetresPerSecond(5.03);
        dip.tank->speed = MillimetresPerSecond(5);
        QVERIFY2(faults(dip).contains(QStringLiteral("at up to 5.03 mm/s")) &&
                     faults(dip).contains(QStringLiteral("reaches only 5.00 mm/s")),
                 qPrintable(faults(dip)));
    }

    // A box that enters tilted covers more of the water until it is level.
    void tankFaults_tiltedEntry_comparesTheWholePath() {
        TankDip dip = boxInTank();
        dip.film.width = Millimetres(41);
        dip.tank->width = Millimetres(41);
        QCOMPARE(faults(dip), QString());
        dip.immersion.path.kind = PathKind::Tilt;
        dip.immersion.path.angle = Degrees(20);
        QVERIFY(faults(dip).contains(QStringLiteral("past the edge of the tank")));
    }
};

QTEST_GUILESS_MAIN(TankFitTest)
#include "TankFitTest.moc"

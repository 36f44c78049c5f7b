// Tests the poses of a part on its path.
#include "base/Error.h"
#include "dip/Pose.h"
#include "geometry/Shapes.h"

#include <QTest>
#include <cmath>

using namespace dipwright;

namespace {

Immersion onPath(PathKind kind, double angle, double turn = 0) {
    Immersion immersion;
    immersion.path.kind = kind;
    immersion.path.angle = Degrees(angle);
    immersion.path.turn = Degrees(turn);
    return immersion;
}

// Returns a box in its pose frame.
TriangleMesh posedBox() {
    const TriangleMesh box = boxMesh({60, 20, 30});
    return transformed(box, poseTransform(box, Immersion()));
}

double lowestAt(const solver::BodyPath& path, const TriangleMesh& posed, double way) {
    const Eigen::Isometry3d place = placeOnPath(path, way);
    double lowest = 1e9;
    for (const Eigen::Vector3f& at : posed.positions) {
        lowest = std::min(lowest, (place * at.cast<double>()).y());
    }
    return lowest;
}

} // namespace

class BodyPathTest : public QObject {
    Q_OBJECT

private slots:
    void bodyPath_everyDepth_beginsAboveTheWaterAndEndsAtIt_data() {
        QTest::addColumn<Immersion>("immersion");
        QTest::newRow("slanted") << onPath(PathKind::Slanted, 50);
        QTest::newRow("tilt") << onPath(PathKind::Tilt, 45);
        QTest::newRow("tilt and turn") << onPath(PathKind::Tilt, 15, 30);
        QTest::newRow("roll") << onPath(PathKind::Roll, 90);
        QTest::newRow("turn") << onPath(PathKind::Straight, 0, 10);
        Immersion slow = onPath(PathKind::Straight, 0);
        slow.path.slowSpeed = MillimetresPerSecond(1);
        slow.path.waterSpeed = MillimetresPerSecond(10);
        QTest::newRow("slow in flowing water") << slow;
    }

    // Rounding of the depth must neither lose the last pose nor give two poses at one place.
    void bodyPath_everyDepth_beginsAboveTheWaterAndEndsAtIt() {
        QFETCH(Immersion, immersion);
        const TriangleMesh box = posedBox();
        for (int tenths = 5; tenths <= 700; ++tenths) {
            ProcessSettings process;
            process.depth = Millimetres(tenths / 10.0);
            const solver::BodyPath path = bodyPath(box, immersion, process);
            QVERIFY(path.poses.size() >= 2);
            for (std::size_t i = 1; i < path.poses.size(); ++i) {
                QVERIFY(path.poses[i].travelled > path.poses[i - 1].travelled);
                QVERIFY(path.poses[i].seconds > path.poses[i - 1].seconds);
            }
            const double end = path.poses.back().travelled;
            QVERIFY(std::abs(lowestAt(path, box, 0) - startHeight) < 1e-5);
            QVERIFY2(std::abs(lowestAt(path, box, end) + tenths / 10.0) < 1e-5,
                     qPrintable(QString::number(tenths)));
            QVERIFY(placeOnPath(path, end).linear().isIdentity(1e-9));
        }
    }

    void bodyPath_levelNearTheSurface_turnsInSmallSteps() {
        Immersion immersion = onPath(PathKind::Tilt, 60);
        immersion.path.levelDepth = Millimetres(5);
        ProcessSettings process;
        process.depth = Millimetres(100);
        const TriangleMesh box = posedBox();
        const solver::BodyPath path = bodyPath(box, immersion, process);
        for (double way = 0; way < path.poses.back().travelled; way += 0.5) {
            const double height = lowestAt(path, box, way);
            const double planned =
                startHeight - process.dipSpeed.value() * secondsOnPath(path, way);
            QVERIFY(std::abs(height - planned) < 0.05);
        }
    }

    // The side of the heading enters first.
    void bodyPath_tiltTowardsX_lowersThatSide() {
        const solver::BodyPath path =
            bodyPath(posedBox(), onPath(PathKind::Tilt, 20), ProcessSettings());
        const Eigen::Isometry3d begin = placeOnPath(path, 0);
        QVERIFY((begin * Eigen::Vector3d(30, 0, 0)).y() < (begin * Eigen::Vector3d(-30, 0, 0)).y());
    }

    void bodyPath_farTravel_isRefused() {
        Immersion immersion = onPath(PathKind::Straight, 0);
        immersion.path.waterSpeed = MillimetresPerSecond(200);
        ProcessSettings process;
        process.dipSpeed = MillimetresPerSecond(0.1);
        QVERIFY_EXCEPTION_THROWN(bodyPath(posedBox(), immersion, process), Error);
        QVERIFY_EXCEPTION_THROWN(
            bodyPath(posedBox(), onPath(PathKind::Slanted, 5), ProcessSettings()), Error);
    }

    void bodyPath_inertValues_goStraightDown() {
        QVERIFY(bodyPath(posedBox(), onPath(PathKind::Straight, 30), ProcessSettings())
                    .isStraightDown());
    }
};

QTEST_GUILESS_MAIN(BodyPathTest)
#include "BodyPathTest.moc"

// Tests the poses of a part on its path.
#include "base/Error.h"
#include "dip/PathKeys.h"
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

PathKey key(double seconds, std::optional<double> depth, double x = 0, double tilt = 0) {
    PathKey result;
    result.time = Seconds(seconds);
    result.depth.reset();
    if (depth) {
        result.depth = Millimetres(*depth);
    }
    result.beside[0] = Millimetres(x);
    result.turn[2] = Degrees(tilt);
    return result;
}

// Down by 12 mm with one side first, a wait there, and level to the end.
Immersion throughPoses() {
    Immersion immersion;
    immersion.path.kind = PathKind::Poses;
    immersion.path.keys = {key(0, 0, 0, -30), key(4, 12, 5, -30), key(6, 12, 5, -30),
                           key(10, std::nullopt, -8)};
    return immersion;
}

ProcessSettings toDepth(double millimetres) {
    ProcessSettings process;
    process.depth = Millimetres(millimetres);
    return process;
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
        slow.path.acceleration = MillimetresPerSecondSquared(20);
        QTest::newRow("slow, with a limit of the acceleration") << slow;
        QTest::newRow("poses") << throughPoses();
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

    void bodyPath_poses_areTakenAtTheirTimes() {
        const Immersion immersion = throughPoses();
        const TriangleMesh box = posedBox();
        const solver::BodyPath path = bodyPath(box, immersion, toDepth(18));
        const Eigen::Vector3d pivot(path.pivot[0], path.pivot[1], path.pivot[2]);
        for (const PathKey& key : immersion.path.keys) {
            const double way = travelledAfter(path, key.time.value());
            const Eigen::Isometry3d place = placeOnPath(path, way);
            const double depth = key.time == Seconds(0) ? -startHeight
                                 : key.depth            ? key.depth->value()
                                                        : 18;
            QVERIFY(std::abs(lowestAt(path, box, way) + depth) < 0.01);
            QVERIFY(std::abs((place * pivot).x() - key.beside[0].value()) < 0.01);
            QVERIFY(place.linear().isApprox(rotationMatrix(key.turn), 1e-3));
        }
    }

    // The turns of a pose are about the fixed axes X, then Y, then Z, after the dip's rotation.
    void bodyPath_posesOfATurnedPart_turnAfterItsRotation() {
        const TriangleMesh box = boxMesh({60, 20, 30});
        Immersion immersion;
        immersion.rotation = {Degrees(20), Degrees(-50), Degrees(75)};
        immersion.path.kind = PathKind::Poses;
        immersion.path.keys = {key(0, 0), key(3, 4), key(8, std::nullopt)};
        immersion.path.keys[1].turn = {Degrees(10), Degrees(-25), Degrees(40)};
        const Eigen::Isometry3d pose = poseTransform(box, immersion);
        const solver::BodyPath path = pathOfModel(
            bodyPath(transformed(box, pose), immersion, ProcessSettings()), pose, immersion);
        using Eigen::AngleAxisd, Eigen::Vector3d;
        const auto about = [](double degrees, const Vector3d& axis) {
            return AngleAxisd(degrees * pi / 180, axis).toRotationMatrix();
        };
        const Eigen::Matrix3d wanted = about(40, Vector3d::UnitZ()) *
                                       about(-25, Vector3d::UnitY()) *
                                       about(10, Vector3d::UnitX()) * about(75, Vector3d::UnitZ()) *
                                       about(-50, Vector3d::UnitY()) * about(20, Vector3d::UnitX());
        const Eigen::Matrix3d found = placeOnPath(path, travelledAfter(path, 3)).linear();
        QVERIFY((found - wanted).norm() < 1e-3);
    }

    // More than a whole turn keeps its direction.
    void asPoses_turnOfMoreThanOnce_keepsItsDirection() {
        const TriangleMesh box = posedBox();
        Immersion keyed = onPath(PathKind::Straight, 0, 540);
        keyed.path = asPoses(box, keyed, ProcessSettings());
        for (std::size_t i = 1; i < keyed.path.keys.size(); ++i) {
            const double turned =
                (keyed.path.keys[i].turn[1] - keyed.path.keys[i - 1].turn[1]).value();
            QVERIFY2(turned > 0 && turned < 61, qPrintable(QString::number(turned)));
        }
        QVERIFY(std::abs(keyed.path.keys[0].turn[1].value() + 540) < 0.2);
    }

    // Between two poses, every value stays between the values of the two poses.
    void bodyPath_poses_neverPassTheirValues() {
        const TriangleMesh box = posedBox();
        const solver::BodyPath path = bodyPath(box, throughPoses(), toDepth(18));
        double before = startHeight;
        for (double seconds = 0; seconds < 10; seconds += 0.05) {
            const double height = lowestAt(path, box, travelledAfter(path, seconds));
            QVERIFY2(height < before + 0.02 && height > -18.02,
                     qPrintable(QStringLiteral("%1 mm at %2 s").arg(height).arg(seconds)));
            before = height;
        }
    }

    void bodyPath_acceleration_isKept_data() {
        QTest::addColumn<Immersion>("immersion");
        QTest::newRow("straight") << onPath(PathKind::Straight, 0);
        QTest::newRow("tilt") << onPath(PathKind::Tilt, 45);
        Immersion slow = onPath(PathKind::Straight, 0);
        slow.path.slowSpeed = MillimetresPerSecond(0.5);
        QTest::newRow("slow at both ends") << slow;
        QTest::newRow("poses") << throughPoses();
    }

    // The mean speeds of neighbouring parts of the motion differ by no more than the acceleration
    // allows between the parts' middles; the part begins and ends at rest.
    void bodyPath_acceleration_isKept() {
        QFETCH(Immersion, immersion);
        ProcessSettings process;
        process.depth = Millimetres(30);
        const TriangleMesh box = posedBox();
        const solver::BodyPath fast = bodyPath(box, immersion, process);
        constexpr double most = 8; // mm/s²
        immersion.path.acceleration = MillimetresPerSecondSquared(most);
        const solver::BodyPath path = bodyPath(box, immersion, process);
        double speedBefore = 0, middleBefore = 0;
        for (std::size_t i = 1; i < path.poses.size(); ++i) {
            const solver::PathPose &from = path.poses[i - 1], &to = path.poses[i];
            const double speed = (to.travelled - from.travelled) / (to.seconds - from.seconds);
            const double middle = (to.seconds + from.seconds) / 2;
            QVERIFY2(std::abs(speed - speedBefore) <= most * (middle - middleBefore) * 1.01 + 1e-6,
                     qPrintable(QStringLiteral("%1 to %2 mm/s within %3 s")
                                    .arg(speedBefore)
                                    .arg(speed)
                                    .arg(middle - middleBefore)));
            speedBefore = speed;
            middleBefore = middle;
        }
        QVERIFY(speedBefore <= most * (path.poses.back().seconds - middleBefore) * 1.01);
        if (!fast.isStraightDown()) {
            QVERIFY(path.poses.back().seconds > fast.poses.back().seconds);
            QVERIFY(std::abs(path.poses.back().travelled - fast.poses.back().travelled) < 0.5);
        }
    }

    void asPoses_tilt_followsThePath() {
        const Immersion tilt = onPath(PathKind::Tilt, 40);
        const TriangleMesh box = posedBox();
        const ProcessSettings process;
        Immersion keyed = tilt;
        keyed.path = asPoses(box, tilt, process);
        QCOMPARE(keyed.path.kind, PathKind::Poses);
        const solver::BodyPath path = bodyPath(box, tilt, process);
        const solver::BodyPath other = bodyPath(box, keyed, process);
        for (const PathKey& key : keyed.path.keys) {
            const double seconds = key.time.value();
            const Eigen::Isometry3d one = placeOnPath(path, travelledAfter(path, seconds));
            const Eigen::Isometry3d two = placeOnPath(other, travelledAfter(other, seconds));
            QVERIFY(one.isApprox(two, 0.01));
        }
    }

    void bodyPath_posesThatDoNotFit_areRefused_data() {
        QTest::addColumn<std::vector<PathKey>>("keys");
        QTest::newRow("none") << std::vector<PathKey>();
        QTest::newRow("one") << std::vector<PathKey>{key(0, 0)};
        QTest::newRow("begins late") << std::vector<PathKey>{key(1, 0), key(2, std::nullopt)};
        QTest::newRow("begins under water")
            << std::vector<PathKey>{key(0, 3), key(2, std::nullopt)};
        QTest::newRow("equal times")
            << std::vector<PathKey>{key(0, 0), key(1, 3), key(1, std::nullopt)};
        QTest::newRow("own depth at the end") << std::vector<PathKey>{key(0, 0), key(2, 10)};
        QTest::newRow("turned at the end")
            << std::vector<PathKey>{key(0, 0), key(2, std::nullopt, 0, 10)};
    }

    void bodyPath_posesThatDoNotFit_areRefused() {
        QFETCH(std::vector<PathKey>, keys);
        Immersion immersion = onPath(PathKind::Poses, 0);
        immersion.path.keys = keys;
        QVERIFY_EXCEPTION_THROWN(bodyPath(posedBox(), immersion, ProcessSettings()), Error);
    }

    // The rise counts relative to the depth of 12 mm before it.
    void riseOnPath_pathThatLiftsThePart_isPositive() {
        const auto rise = [](const std::vector<PathKey>& keys) {
            Immersion immersion = onPath(PathKind::Poses, 0);
            immersion.path.keys = keys;
            return riseOnPath(bodyPath(posedBox(), immersion, ProcessSettings()), posedBox());
        };
        QCOMPARE(rise({key(0, 0), key(4, 12), key(8, 12), key(12, std::nullopt)}), 0.0);
        QVERIFY(std::abs(rise({key(0, 0), key(4, 12), key(8, 9), key(12, std::nullopt)}) - 0.25) <
                1e-3);
        QVERIFY(std::abs(rise({key(0, 0), key(4, 12), key(8, -6), key(12, std::nullopt)}) - 1.5) <
                1e-3);
        const Immersion tilted = throughPoses();
        QCOMPARE(riseOnPath(bodyPath(posedBox(), tilted, toDepth(20)), posedBox()), 0.0);
        QCOMPARE(riseOnPath({}, posedBox()), 0.0);
    }

    void bodyPath_farTravel_isRefused() {
        Immersion immersion = onPath(PathKind::Straight, 0);
        immersion.path.waterSpeed = MillimetresPerSecond(200);
        ProcessSettings process;
        process.dipSpeed = MillimetresPerSecond(0.1);
        QVERIFY_EXCEPTION_THROWN(bodyPath(posedBox(), immersion, process), Error);
        QVERIFY_EXCEPTION_THROWN(
            bodyPath(posedBox(), onPath(PathKind::Slanted, 5), ProcessSettings()), Error);
        QVERIFY_EXCEPTION_THROWN(
            bodyPath(posedBox(), onPath(PathKind::Roll, -400), ProcessSettings()), Error);
    }

    void bodyPath_inertValues_goStraightDown() {
        QVERIFY(bodyPath(posedBox(), onPath(PathKind::Straight, 30), ProcessSettings())
                    .isStraightDown());
    }
};

QTEST_GUILESS_MAIN(BodyPathTest)
#include "BodyPathTest.moc"

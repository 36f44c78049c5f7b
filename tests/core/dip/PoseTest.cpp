// Tests the pose of a body in a dip: frames, angles and travel.
#include "DippedByHand.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

// Returns a box away from the origin, so that a rotation about the origin would show.
TriangleMesh farBox() {
    TriangleMesh box = boxMesh({10, 20, 30});
    for (Eigen::Vector3f& position : box.positions) {
        position += Eigen::Vector3f(100, 200, 300);
    }
    return box;
}

Immersion turned(double x, double y, double z) {
    Immersion immersion;
    immersion.rotation = {Degrees(x), Degrees(y), Degrees(z)};
    return immersion;
}

bool isNear(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    return (one - other).norm() < 1e-4;
}

} // namespace

class PoseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void posedBody_standsOnTheWaterPlaneOverTheOrigin();
    void posedBody_quarterTurns_swapTheEdges();
    void poseTransform_turnsAboutXThenYThenZ();
    void posedBody_leaning_restsOnItsLowestCorner();
    void poseTransform_offset_doesNotMoveThePose();
    void rotationAngles_ofARotation_giveTheSameRotation_data();
    void rotationAngles_ofARotation_giveTheSameRotation();
    void dipTravel_endsAtMarginOrDepth();
};

void PoseTest::posedBody_standsOnTheWaterPlaneOverTheOrigin() {
    const PosedBody body = posedBody(farBox(), Immersion{});
    const BoundingBox box = boundingBox(body.mesh);
    QVERIFY(isNear(box.min().cast<double>(), {-5, 0, -15}));
    QVERIFY(isNear(box.max().cast<double>(), {5, 20, 15}));
    QVERIFY(std::abs(body.height - 20) < 1e-4);
    QVERIFY(isNear(body.modelToPose * Eigen::Vector3d(100, 190, 300), {0, 0, 0}));
}

void PoseTest::posedBody_quarterTurns_swapTheEdges() {
    QVERIFY(std::abs(posedBody(farBox(), turned(90, 0, 0)).height - 30) < 1e-4);
    QVERIFY(std::abs(posedBody(farBox(), turned(0, 90, 0)).height - 20) < 1e-4);
    QVERIFY(std::abs(posedBody(farBox(), turned(0, 0, 90)).height - 10) < 1e-4);
}

void PoseTest::poseTransform_turnsAboutXThenYThenZ() {
    const Eigen::Isometry3d pose = poseTransform(farBox(), turned(90, 90, 0));
    // About X, +Y goes to +Z; then about Y, +Z goes to +X.
    QVERIFY(isNear(pose.linear() * Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()));
    const Eigen::Isometry3d other = poseTransform(farBox(), turned(0, 90, 90));
    // About Y, +Z goes to +X; then about Z, +X goes to +Y.
    QVERIFY(isNear(other.linear() * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()));
}

void PoseTest::posedBody_leaning_restsOnItsLowestCorner() {
    const PosedBody body = posedBody(farBox(), turned(31, -57, 12));
    const BoundingBox box = boundingBox(body.mesh);
    QVERIFY(std::abs(box.min().y()) < 1e-4);
    QVERIFY(std::abs(box.max().y() - body.height) < 1e-4);
    QVERIFY(std::abs(box.center().x()) < 1e-4 && std::abs(box.center().z()) < 1e-4);
}

void PoseTest::poseTransform_offset_doesNotMoveThePose() {
    Immersion beside;
    beside.offset = {Millimetres(40), Millimetres(-25)};
    QVERIFY(poseTransform(farBox(), beside).isApprox(poseTransform(farBox(), Immersion{})));
}

void PoseTest::rotationAngles_ofARotation_giveTheSameRotation_data() {
    QTest::addColumn<QVector<double>>("angles");
    QTest::newRow("no rotation") << QVector<double>{0, 0, 0};
    QTest::newRow("three angles") << QVector<double>{31, -57, 12};
    QTest::newRow("angles near 180 degrees") << QVector<double>{-170, 20, 175.5};
    QTest::newRow("upside down") << QVector<double>{180, 0, 0};
    // After a quarter turn about Y, rotations about X and Z have the same axis.
    QTest::newRow("quarter turn") << QVector<double>{30, 90, 0};
    QTest::newRow("other quarter turn") << QVector<double>{0, -90, 45};
}

void PoseTest::rotationAngles_ofARotation_giveTheSameRotation() {
    QFETCH(QVector<double>, angles);
    const Eigen::Matrix3d rotation =
        rotationMatrix({Degrees(angles[0]), Degrees(angles[1]), Degrees(angles[2])});
    const std::array<Degrees, 3> back = rotationAngles(rotation);
    const std::array<Degrees, 3> same = rotationAngles(
        rotation, {Degrees(angles[0] + 1), Degrees(angles[1] + 1), Degrees(angles[2] - 1)});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QVERIFY2(std::abs(same[axis].value() - angles[qsizetype(axis)]) < 1.5,
                 qPrintable(QStringLiteral("angle %1°, expected %2°")
                                .arg(same[axis].value())
                                .arg(angles[qsizetype(axis)])));
    }
    for (const Degrees angle : back) {
        QVERIFY(std::abs(angle.value() * 10 - std::round(angle.value() * 10)) < 1e-9);
        QVERIFY(!std::signbit(angle.value()) || angle.value() < 0); // no −0
    }
    QVERIFY((rotationMatrix(back) - rotation).norm() < radians(Degrees(0.2)));
}

void PoseTest::dipTravel_endsAtMarginOrDepth() {
    const PosedBody body = posedBody(farBox(), Immersion{}); // 20 mm high
    ProcessSettings process;
    process.margin = Millimetres(3);
    QVERIFY(std::abs(dipTravel(process, body) - (startHeight + 20 + 3)) < 1e-4);
    process.depth = Millimetres(12);
    Immersion beside;
    beside.offset = {Millimetres(40), Millimetres(-25)};
    QVERIFY(isNear(poseToWorld(beside, 0), {40, startHeight, -25}));
    QVERIFY(isNear(poseToWorld(beside, dipTravel(process, body)), {40, -12, -25}));
}

QTEST_APPLESS_MAIN(PoseTest)
#include "PoseTest.moc"

// Air under hollows: how much of the body the water never reaches.
#include "dip/TrappedAir.h"
#include "DippedByHand.h"
#include "base/Units.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

void append(TriangleMesh& mesh, const TriangleMesh& other, const Eigen::Vector3f& shift) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const Eigen::Vector3f& position : other.positions) {
        mesh.positions.push_back(position + shift);
    }
    for (const auto& [a, b, c] : other.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
    }
}

// A profile of (radius, height) turned round the Y axis, first point to last seen from outside with
// the axis to the left.
TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile, int segments) {
    TriangleMesh mesh;
    const auto count = std::uint32_t(segments);
    for (const Eigen::Vector2d& point : profile) {
        for (std::uint32_t segment = 0; segment < count; ++segment) {
            const double angle = 2 * pi * segment / segments;
            mesh.positions.push_back(
                Eigen::Vector3d(point.x() * std::cos(angle), point.y(), point.x() * std::sin(angle))
                    .cast<float>());
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::uint32_t segment = 0; segment < count; ++segment) {
            const std::uint32_t next = (segment + 1) % count;
            const std::uint32_t below = ring * count;
            const std::uint32_t above = below + count;
            mesh.triangles.push_back({below + segment, above + segment, above + next});
            mesh.triangles.push_back({below + segment, above + next, below + next});
        }
    }
    return mesh;
}

// A cup of outer radius 30, wall 3 and height 40; its inside is a pit 37 deep.
TriangleMesh cup() {
    return turned({{0, 0}, {30, 0}, {30, 40}, {27, 40}, {27, 3}, {0, 3}}, 96);
}
constexpr double pitArea = pi * 27 * 27 + 2 * pi * 27 * 37;

TrappedAir airIn(const TriangleMesh& mesh, const std::array<double, 3>& degrees) {
    Immersion immersion;
    immersion.rotation = {Degrees(degrees[0]), Degrees(degrees[1]), Degrees(degrees[2])};
    return trappedAir(posedBody(mesh, immersion));
}
double trapped(const TriangleMesh& mesh, const std::array<double, 3>& degrees = {0, 0, 0}) {
    return airIn(mesh, degrees).area;
}

} // namespace

class TrappedAirTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void convexBodiesTrapNothing();
    void cupWithItsMouthUpTrapsNothing();
    void cupWithItsMouthDownTrapsAllItsInside();
    void itIsCaughtAtTheMouth();
    void cupOnItsSideTrapsTheUpperHalf();
    void thinWallsHoldAirToo();
    void archLetsTheAirGo();
};

void TrappedAirTest::convexBodiesTrapNothing() {
    QCOMPARE(trapped(sphereMesh(35, 60, 120)), 0.0);
    QCOMPARE(trapped(boxMesh({60, 30, 40})), 0.0);
    QCOMPARE(trapped(boxMesh({60, 30, 40}), {13, 0, 29}), 0.0);
    QCOMPARE(trapped(tetrahedronMesh(60)), 0.0);
}

void TrappedAirTest::cupWithItsMouthUpTrapsNothing() {
    QCOMPARE(trapped(cup()), 0.0);
}

void TrappedAirTest::cupWithItsMouthDownTrapsAllItsInside() {
    const double area = trapped(cup(), {180, 0, 0});
    QVERIFY2(std::abs(area - pitArea) < 0.05 * pitArea, qPrintable(QString::number(area)));
}

void TrappedAirTest::itIsCaughtAtTheMouth() {
    QCOMPARE(airIn(cup(), {0, 0, 0}).height, std::nullopt);
    const std::optional<double> upsideDown = airIn(cup(), {180, 0, 0}).height;
    QVERIFY2(upsideDown && *upsideDown < 2, qPrintable(QString::number(upsideDown.value_or(-1))));
    // On a stand of 20 under its base the same cup is upside down with its mouth 20 up.
    TriangleMesh raised = cup();
    append(raised, boxMesh({4, 60, 4}), {0, 30, 0});
    const std::optional<double> height = airIn(raised, {180, 0, 0}).height;
    QVERIFY2(height && std::abs(*height - 20) < 2,
             qPrintable(QString::number(height.value_or(-1))));
}

void TrappedAirTest::cupOnItsSideTrapsTheUpperHalf() {
    // Lying on its side the water comes in at the mouth; tipped 30° further down, air stays above
    // the mouth's upper lip.
    QVERIFY(trapped(cup(), {90, 0, 0}) < 0.02 * pitArea);
    const double tipped = trapped(cup(), {120, 0, 0});
    QVERIFY(tipped > 0.1 * pitArea && tipped < 0.8 * pitArea);
}

void TrappedAirTest::thinWallsHoldAirToo() {
    // A bell of 0.2 mm, thinner than a cell of the grid.
    const TriangleMesh bell =
        turned({{30, 0}, {30, 40}, {0, 40}, {0, 39.8}, {29.8, 39.8}, {29.8, 0}, {30, 0}}, 96);
    const double inside = pi * 29.8 * 29.8 + 2 * pi * 29.8 * 39.8;
    const double area = trapped(bell);
    QVERIFY2(std::abs(area - inside) < 0.06 * inside, qPrintable(QString::number(area)));
}

void TrappedAirTest::archLetsTheAirGo() {
    TriangleMesh table = boxMesh({60, 5, 40});
    for (const float x : {-27.0f, 27.0f}) {
        append(table, boxMesh({6, 30, 40}), {x, -17.5f, 0});
    }
    QCOMPARE(trapped(table), 0.0);
}

QTEST_APPLESS_MAIN(TrappedAirTest)
#include "TrappedAirTest.moc"

// Tests trapped air: how much of the body's surface the water never reaches.
#include "dip/TrappedAir.h"
#include "HollowBodies.h"
#include "JoinedMeshes.h"
#include "base/Units.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dipwright;
using namespace dipwright::test;

namespace {

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
    void trappedAir_convexBodies_isNone();
    void trappedAir_cupMouthUp_isNone();
    void trappedAir_cupMouthDown_fillsItsWholeInside();
    void trappedAir_cupMouthDown_startsAtTheMouthsHeight();
    void trappedAir_tippedCup_fillsPartOfItsInside();
    void trappedAir_wallThinnerThanACell_holdsAir();
    void trappedAir_arch_isNone();
    void trappedAir_bowlRimDown_fillsItsWholeInside();
    void airPocketLevel_tippedCup_isTheHeightOfItsUpperLip_data();
    void airPocketLevel_tippedCup_isTheHeightOfItsUpperLip();
    void trappedAir_bottleNeckDown_fillsItsWholeInside();
    void trappedAir_ring_isNone();
    void trappedAir_shallowHollow_isFoundDownToTwoLayers();
    void trappedAir_boresOfAJig_areAllFound();
};

void TrappedAirTest::trappedAir_convexBodies_isNone() {
    QCOMPARE(trapped(sphereMesh(35, 60, 120)), 0.0);
    QCOMPARE(trapped(boxMesh({60, 30, 40})), 0.0);
    QCOMPARE(trapped(boxMesh({60, 30, 40}), {13, 0, 29}), 0.0);
    QCOMPARE(trapped(tetrahedronMesh(60)), 0.0);
}

void TrappedAirTest::trappedAir_cupMouthUp_isNone() {
    QCOMPARE(trapped(cup()), 0.0);
}

void TrappedAirTest::trappedAir_cupMouthDown_fillsItsWholeInside() {
    const double area = trapped(cup(), {180, 0, 0});
    QVERIFY2(std::abs(area - pitArea) < 0.05 * pitArea,
             qPrintable(QStringLiteral("dry area %1 mm², expected %2 mm²").arg(area).arg(pitArea)));
}

void TrappedAirTest::trappedAir_cupMouthDown_startsAtTheMouthsHeight() {
    QCOMPARE(airIn(cup(), {0, 0, 0}).travelled, std::nullopt);
    const std::optional<double> upsideDown = airIn(cup(), {180, 0, 0}).travelled;
    QVERIFY2(
        upsideDown && *upsideDown < 2,
        qPrintable(
            QStringLiteral("water level %1 mm, expected < 2 mm").arg(upsideDown.value_or(-1))));
    // The same cup, upside down on a stand 20 mm high, has its mouth 20 mm higher.
    const TriangleMesh raised = joined(cup(), boxMesh({4, 60, 4}), {0, 30, 0});
    const std::optional<double> height = airIn(raised, {180, 0, 0}).travelled;
    QVERIFY2(
        height && std::abs(*height - startHeight - 20) < 2,
        qPrintable(QStringLiteral("water level %1 mm, expected 20 mm").arg(height.value_or(-1))));
}

void TrappedAirTest::trappedAir_tippedCup_fillsPartOfItsInside() {
    // A cup that lies on its side fills with water. Tipped 30° further, it keeps air above the
    // upper lip of its mouth.
    QVERIFY(trapped(cup(), {90, 0, 0}) < 0.02 * pitArea);
    const double tipped = trapped(cup(), {120, 0, 0});
    QVERIFY(tipped > 0.1 * pitArea && tipped < 0.8 * pitArea);
}

void TrappedAirTest::trappedAir_wallThinnerThanACell_holdsAir() {
    // A bell with a wall of 0.2 mm, which is thinner than a cell of the grid.
    const TriangleMesh bell =
        turned({{30, 0}, {30, 40}, {0, 40}, {0, 39.8}, {29.8, 39.8}, {29.8, 0}, {30, 0}}, 96);
    const double inside = pi * 29.8 * 29.8 + 2 * pi * 29.8 * 39.8;
    const double area = trapped(bell);
    QVERIFY2(std::abs(area - inside) < 0.06 * inside,
             qPrintable(QStringLiteral("dry area %1 mm², expected %2 mm²").arg(area).arg(inside)));
}

void TrappedAirTest::trappedAir_arch_isNone() {
    TriangleMesh table = boxMesh({60, 5, 40});
    for (const float x : {-27.0f, 27.0f}) {
        table = joined(table, boxMesh({6, 30, 40}), {x, -17.5f, 0});
    }
    QCOMPARE(trapped(table), 0.0);
}

void TrappedAirTest::trappedAir_bowlRimDown_fillsItsWholeInside() {
    constexpr double inner = bowlRadius - bowlWall;
    const double area = trapped(bowl());
    QVERIFY2(std::abs(area - 2 * pi * inner * inner) < 0.01 * 2 * pi * inner * inner,
             qPrintable(QStringLiteral("dry area %1 mm², expected %2 mm²")
                            .arg(area)
                            .arg(2 * pi * inner * inner)));
    const TriangleMesh mesh = bowl();
    const PosedBody body = posedBody(mesh, {});
    QCOMPARE(body.air.all().size(), std::size_t(1));
    QVERIFY(std::abs(body.air.all().front().level) < 0.02 * double(body.air.cell()));
    for (std::uint32_t triangle = 0; triangle < body.mesh.triangles.size(); ++triangle) {
        const float fromMiddle = position(body.mesh, middleOf(triangle)).norm();
        const bool isRim = triangleNormal(body.mesh, triangle).y() < -0.99f && fromMiddle > 29.1f &&
                           position(body.mesh, middleOf(triangle)).y() < 0.1f;
        QCOMPARE(body.isDry(middleOf(triangle)), !isRim && fromMiddle < 30.5f);
    }
    QCOMPARE(trapped(bowl(), {180, 0, 0}), 0.0);
    QCOMPARE(trapped(bowl(3)), 0.0); // the air escapes through the hole
}

void TrappedAirTest::airPocketLevel_tippedCup_isTheHeightOfItsUpperLip_data() {
    QTest::addColumn<double>(
        "turn"); // rotation about X, degrees: 90 lays the cup on its side, 180 on its mouth
    QTest::newRow("tipped a little") << 100.0;
    QTest::newRow("tipped more") << 120.0;
    QTest::newRow("tipped far, and askew") << 151.0;
}

void TrappedAirTest::airPocketLevel_tippedCup_isTheHeightOfItsUpperLip() {
    QFETCH(double, turn);
    Immersion immersion;
    immersion.rotation = {Degrees(turn), Degrees(0), Degrees(turn > 150 ? 7 : 0)};
    const PosedBody body = posedBody(cup(), immersion);
    const auto height = [&](double radius, double angle, double along) {
        return (body.modelToPose *
                Eigen::Vector3d(radius * std::cos(angle), along, radius * std::sin(angle)))
            .y();
    };
    // The air escapes at the highest place of the mouth's inner edge.
    constexpr int steps = 720;
    double lip = -1000;
    for (int step = 0; step < steps; ++step) {
        lip = std::max(lip, height(27, 2 * pi * step / steps, 40));
    }
    QCOMPARE(body.air.all().size(), std::size_t(1));
    const double level = body.air.all().front().level;
    QVERIFY2(std::abs(level - lip) < 0.1 * double(body.air.cell()),
             qPrintable(QStringLiteral("level %1 mm, expected %2 mm").arg(level).arg(lip)));
    // The area of the inside above that level, in mm².
    double above = 0;
    for (int step = 0; step < steps; ++step) {
        const double angle = 2 * pi * (step + 0.5) / steps;
        constexpr int pieces = 200;
        for (int piece = 0; piece < pieces; ++piece) {
            const double share = (piece + 0.5) / pieces;
            above +=
                height(27, angle, 3 + 37 * share) > lip ? 2 * pi * 27 * 37 / (steps * pieces) : 0;
            above += height(27 * share, angle, 3) > lip
                         ? 2 * pi * 27 * share * 27 / (steps * pieces)
                         : 0;
        }
    }
    const double area = trappedAir(body).area;
    QVERIFY2(std::abs(area - above) < 0.015 * above,
             qPrintable(QStringLiteral("area %1 mm², expected %2 mm²").arg(area).arg(above)));
}

void TrappedAirTest::trappedAir_bottleNeckDown_fillsItsWholeInside() {
    // The inside is a cylinder of radius 18 mm and height 36 mm, with a neck of radius 4 mm and
    // length 17 mm that is open below.
    const TriangleMesh bottle = turned({{0, 53},
                                        {18, 53},
                                        {18, 17},
                                        {4, 17},
                                        {4, 0},
                                        {6, 0},
                                        {6, 15},
                                        {20, 15},
                                        {20, 55},
                                        {0, 55}},
                                       96);
    const double inside =
        2 * pi * 18 * 36 + 2 * pi * 4 * 17 + pi * 18 * 18 + pi * (18 * 18 - 4 * 4);
    const double area = trapped(bottle);
    QVERIFY2(std::abs(area - inside) < 0.01 * inside,
             qPrintable(QStringLiteral("dry area %1 mm², expected %2 mm²").arg(area).arg(inside)));
    QCOMPARE(trapped(bottle, {180, 0, 0}), 0.0);
}

void TrappedAirTest::trappedAir_ring_isNone() {
    // Its inside is a saddle, in which a way up leads from every place.
    for (const double tilt : {0.0, 25.0, 60.0, 90.0}) {
        QCOMPARE(trapped(torusMesh(24, 7, 60, 40), {tilt, 0, 0}), 0.0);
    }
}

void TrappedAirTest::trappedAir_shallowHollow_isFoundDownToTwoLayers() {
    // A block with a pit of radius 10 mm in its bottom. How wide the block is does not matter.
    const auto block = [](double depth, double radius) {
        return turned({{0, depth}, {10, depth}, {10, 0}, {radius, 0}, {radius, 20}, {0, 20}}, 48);
    };
    QCOMPARE(trapped(block(airLayer, 30)), 0.0);
    for (const double radius : {30.0, 100.0}) {
        for (const double depth : {0.8, 1.4, 3.0}) {
            const double area = trapped(block(depth, radius));
            const double dry = pi * 10 * 10 + 2 * pi * 10 * depth;
            QVERIFY2(std::abs(area - dry) < 0.03 * dry,
                     qPrintable(QStringLiteral("%1 mm, %2 mm: dry area %3 mm², expected %4 mm²")
                                    .arg(radius)
                                    .arg(depth)
                                    .arg(area)
                                    .arg(dry)));
        }
    }
}

// A row of five blocks, each with a blind bore of 6 × 15 mm from below.
void TrappedAirTest::trappedAir_boresOfAJig_areAllFound() {
    const TriangleMesh block = turned({{0, 15}, {3, 15}, {3, 0}, {13, 0}, {13, 30}, {0, 30}}, 48);
    TriangleMesh row;
    for (int number = 0; number < 5; ++number) {
        row = joined(row, block, {55.0f * float(number), 0, 0});
    }
    const double dry = 5 * (pi * 3 * 3 + 2 * pi * 3 * 15), area = trapped(row);
    QVERIFY2(std::abs(area - dry) < 0.05 * dry,
             qPrintable(QStringLiteral("%1, expected %2 mm²").arg(area).arg(dry)));
    QCOMPARE(airCellsAlong({110, 30, 75}), airCells);
    QCOMPARE(airCellsAlong({240, 30, 30}), 192);
    QCOMPARE(airCellsAlong({300, 300, 300}), airCells);
}

QTEST_APPLESS_MAIN(TrappedAirTest)
#include "TrappedAirTest.moc"

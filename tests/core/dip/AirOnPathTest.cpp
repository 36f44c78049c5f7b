// Tests the air that hollows keep while a part moves along a path.
#include "HollowBodies.h"
#include "dip/Pose.h"
#include "dip/TrappedAir.h"

#include <QTest>
#include <cmath>

using namespace dipwright;

namespace {

constexpr double inner = 50, wall = 3;  // mm
constexpr double slope = 35 * pi / 180; // of the inner wall at the rim

// A part of a hollow ball with its hollow down. Its lowest place is the rim of the inner wall.
TriangleMesh shallowBowl() {
    constexpr int steps = 40;
    std::vector<Eigen::Vector2d> profile;
    for (const bool isInner : {true, false}) {
        const double radius = isInner ? inner : inner + wall;
        for (int step = 0; step <= steps; ++step) {
            const double angle = slope * (isInner ? step : steps - step) / steps;
            profile.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
        }
    }
    return test::turned(profile, 160);
}

double insideArea() {
    return 2 * pi * inner * inner * (1 - std::cos(slope));
}

// Returns a bowl that enters tilted by `degrees` and is level at the depth `levelDepth`, in mm.
PosedBody tiltedBowl(double degrees, double levelDepth, double depth) {
    Immersion immersion;
    immersion.path.kind = PathKind::Tilt;
    immersion.path.angle = Degrees(degrees);
    immersion.path.levelDepth = Millimetres(levelDepth);
    ProcessSettings process;
    process.depth = Millimetres(depth);
    return posedBody(shallowBowl(), immersion, process);
}

} // namespace

class AirOnPathTest : public QObject {
    Q_OBJECT

private slots:
    // The bowl is still tilted when all of it is under water. The hollow has a way out that rises
    // all the way only if the tilt exceeds the slope at the rim, 35°.
    void posedBody_shallowBowlTilted_keepsAirUpToTheSlopeAtItsRim() {
        const double level =
            trappedAir(posedBody(shallowBowl(), Immersion(), ProcessSettings())).area;
        QVERIFY(level > 0.9 * insideArea());
        double before = level;
        for (const double degrees : {10.0, 20.0, 30.0}) {
            const double dry = trappedAir(tiltedBowl(degrees, 400, 104)).area;
            qInfo("%g°: %.1f %% of the inside stays dry", degrees, 100 * dry / insideArea());
            QVERIFY(dry > 0 && dry < before);
            before = dry;
        }
        QCOMPARE(trappedAir(tiltedBowl(60, 400, 120)).area, 0.0);
    }

    // Each place of the inner wall goes under water at one moment. Its air is cut off if the whole
    // rim is under water then.
    void posedBody_shallowBowlLevelledWhileItSinks_keepsTheAirOfTheGeometry() {
        const PosedBody body = tiltedBowl(25, 14, 30);
        const double rim = inner * std::sin(slope), down = inner * std::cos(slope);
        constexpr int count = 100;
        double dry = 0, all = 0;
        for (int i = 0; i < count; ++i) {
            const double angle = slope * (i + 0.5) / count;
            for (int j = 0; j < 2 * count; ++j) {
                const double round = pi * (j + 0.5) / count;
                const Eigen::Vector3d place(inner * std::sin(angle) * std::cos(round),
                                            inner * std::cos(angle) - down,
                                            inner * std::sin(angle) * std::sin(round));
                const auto way = firstUnderWater(body.path, place);
                QVERIFY(way.has_value());
                const Eigen::Isometry3d at = placeOnPath(body.path, *way);
                double highest = -100;
                for (int k = 0; k < 90; ++k) {
                    const double turn = 2 * pi * k / 90;
                    highest = std::max(
                        highest,
                        (at * Eigen::Vector3d(rim * std::cos(turn), 0, rim * std::sin(turn))).y());
                }
                const double area =
                    inner * inner * std::sin(angle) * (slope / count) * (pi / count);
                all += area;
                dry += highest < 0 ? area : 0;
            }
        }
        const double found = trappedAir(body).area;
        qInfo("%.1f %% of the inside stays dry, by geometry %.1f %%", 100 * found / all,
              100 * dry / all);
        QVERIFY(dry > 0.1 * all && dry < 0.9 * all);
        QVERIFY(std::abs(found - dry) < 0.05 * all);
    }

    // A cup with its opening up takes no air down, however it is turned about the vertical.
    void posedBody_cupThatTurns_keepsNoAir() {
        Immersion immersion;
        immersion.path.turn = Degrees(90);
        QVERIFY(posedBody(test::cup(), immersion, ProcessSettings()).air.isEmpty());
    }
};

QTEST_GUILESS_MAIN(AirOnPathTest)
#include "AirOnPathTest.moc"

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

// A part that enters tilted by `degrees` and is level at the depth `levelDepth`, in mm.
PosedBody tilted(const TriangleMesh& body, double degrees, double levelDepth, double depth) {
    Immersion immersion;
    immersion.path.kind = PathKind::Tilt;
    immersion.path.angle = Degrees(degrees);
    immersion.path.levelDepth = Millimetres(levelDepth);
    ProcessSettings process;
    process.depth = Millimetres(depth);
    return posedBody(body, immersion, process);
}

// A part of the surface inside a hollow, in the pose frame.
struct InsidePatch {
    Eigen::Vector3d place;
    double area = 0; // mm²
};

// A body of revolution with its hollow down.
struct Hollow {
    TriangleMesh body;
    std::vector<InsidePatch> inside;
    std::vector<Eigen::Vector3d> rim; // edges of the opening, in the pose frame
};

Eigen::Vector3d onCircle(double radius, double height, double angle) {
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

// Adds the surface that a straight line makes when it turns about the Y axis. The ends of the line
// are (radius, height).
void addInside(Hollow& hollow, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    constexpr int along = 60, round = 120;
    for (int i = 0; i < along; ++i) {
        const Eigen::Vector2d at = from + (i + 0.5) / along * (to - from);
        const double area = (to - from).norm() / along * 2 * pi * at.x() / round;
        for (int j = 0; j < round; ++j) {
            hollow.inside.push_back({onCircle(at.x(), at.y(), 2 * pi * (j + 0.5) / round), area});
        }
    }
}
void addRim(Hollow& hollow, double radius) {
    for (int k = 0; k < 90; ++k) {
        hollow.rim.push_back(onCircle(radius, 0, 2 * pi * k / 90));
    }
}

Hollow shallowBowlDown() {
    Hollow hollow{shallowBowl(), {}, {}};
    const double down = inner * std::cos(slope);
    constexpr int parts = 40;
    const auto at = [&](int part) -> Eigen::Vector2d {
        const double angle = slope * part / parts;
        return {inner * std::sin(angle), inner * std::cos(angle) - down};
    };
    for (int part = 0; part < parts; ++part) {
        addInside(hollow, at(part), at(part + 1));
    }
    addRim(hollow, inner * std::sin(slope));
    return hollow;
}

// A cup of inner radius 27 mm that is 37 mm deep.
Hollow cupDown() {
    Hollow hollow{
        test::turned({{0, 37}, {27, 37}, {27, 0}, {30, 0}, {30, 40}, {0, 40}}, 96), {}, {}};
    addInside(hollow, {0, 37}, {27, 37});
    addInside(hollow, {27, 37}, {27, 0});
    addRim(hollow, 27);
    return hollow;
}

// A ring with a groove from radius 20 to 35 mm that is 15 mm deep.
Hollow groovedRingDown() {
    Hollow hollow{
        test::turned(
            {{17, 0}, {20, 0}, {20, 15}, {35, 15}, {35, 0}, {38, 0}, {38, 18}, {17, 18}, {17, 0}},
            96),
        {},
        {}};
    addInside(hollow, {20, 0}, {20, 15});
    addInside(hollow, {20, 15}, {35, 15});
    addInside(hollow, {35, 15}, {35, 0});
    addRim(hollow, 20);
    addRim(hollow, 35);
    return hollow;
}

// Returns the area, mm², to which air clings by geometry. Each place inside goes under water at one
// moment. Its air is cut off if the whole rim is under water then.
double dryArea(const Hollow& hollow, const solver::BodyPath& path) {
    double dry = 0;
    for (const InsidePatch& patch : hollow.inside) {
        const auto way = firstUnderWater(path, patch.place);
        if (!way) {
            continue;
        }
        const Eigen::Isometry3d at = placeOnPath(path, *way);
        const bool isCutOff =
            std::all_of(hollow.rim.begin(), hollow.rim.end(),
                        [&](const Eigen::Vector3d& place) { return (at * place).y() < 0; });
        dry += isCutOff ? patch.area : 0;
    }
    return dry;
}

double areaOf(const Hollow& hollow) {
    double area = 0;
    for (const InsidePatch& patch : hollow.inside) {
        area += patch.area;
    }
    return area;
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
            const double dry = trappedAir(tilted(shallowBowl(), degrees, 400, 104)).area;
            qInfo("%g°: %.1f %% of the inside stays dry", degrees, 100 * dry / insideArea());
            QVERIFY(dry > 0 && dry < before);
            before = dry;
        }
        QCOMPARE(trappedAir(tilted(shallowBowl(), 60, 400, 120)).area, 0.0);
    }

    void posedBody_hollowLevelledWhileItSinks_keepsTheAirOfTheGeometry_data() {
        QTest::addColumn<int>("body");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("levelDepth");
        QTest::newRow("bowl") << 0 << 25.0 << 14.0;
        QTest::newRow("cup, tilted a little") << 1 << 20.0 << 30.0;
        QTest::newRow("cup, tilted far") << 1 << 50.0 << 45.0;
        QTest::newRow("ring with a groove") << 2 << 20.0 << 20.0;
    }
    void posedBody_hollowLevelledWhileItSinks_keepsTheAirOfTheGeometry() {
        QFETCH(int, body);
        QFETCH(double, degrees);
        QFETCH(double, levelDepth);
        const Hollow hollow = body == 0   ? shallowBowlDown()
                              : body == 1 ? cupDown()
                                          : groovedRingDown();
        const PosedBody posed = tilted(hollow.body, degrees, levelDepth, levelDepth + 20);
        const double all = areaOf(hollow), dry = dryArea(hollow, posed.path);
        const double found = trappedAir(posed).area;
        qInfo("%.1f %% of the inside stays dry, by geometry %.1f %%", 100 * found / all,
              100 * dry / all);
        QVERIFY(dry > 0.1 * all && dry < 0.95 * all);
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

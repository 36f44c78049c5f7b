// Tests the production film on the CPU: finer grids, shorter steps, other numbers of threads, and
// the behaviour at edges, tips and overhangs.

#include "JoinedMeshes.h"
#include "ProductionDips.h"
#include "geometry/Shapes.h"
#include "production/formulas/Adhesion.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstring>

using namespace dipwright;
using namespace dipwright::test;

namespace {

// Returns two balls of 15 mm radius, with a gap of 2 mm as seen from above. The second ball is 18
// mm higher.
TriangleMesh twoBalls() {
    const TriangleMesh one = sphereMesh(15, 96, 192);
    return joined(one, one, {30, 18, 11});
}

// Returns a dip of a film of 240 × 80 mm that grows before the body touches it. Its left side, or
// both its left and right sides, are pinned.
solver::DipSetup growingStrip(const Body& body, double relaxationTime, bool isHeldRightToo) {
    solver::DipSetup setup = squareDip(body, 71, 20);
    setup.film = {.columns = 121, .rows = 41, .width = 240, .depth = 80};
    setup.motion.start[1] += 25;
    setup.settings.relaxationTime = relaxationTime;
    setup.settings.growthRate = 0.02;
    setup.settings.growthLimit = 0.2;
    setup.pinned.assign(setup.film.pointCount(), 0);
    for (std::size_t row = 0; row < 41; ++row) {
        setup.pinned[row * 121] = 1;
        setup.pinned[row * 121 + 120] = isHeldRightToo;
    }
    return setup;
}
double grownAtTheEnd(const solver::DipSetup& setup) {
    const double seconds = setup.motion.travel / setup.motion.speed;
    return 1 + 0.2 * (1 - std::exp(-0.02 * seconds / 0.2));
}

} // namespace

class ProductionFilmTest : public QObject {
    Q_OBJECT

private slots:
    void productionFilm_finerGridOrShorterStep_changeLittle();
    void productionFilm_thinLeg_dependsLittleOnTheStep();
    void productionFilm_secondContact_dependsLittleOnTheStep();
    void productionFilm_anyNumberOfThreads_giveTheSameBits();
    void productionFilm_withoutGrowth_givesTheSameBits();
    void productionFilm_beforeContact_doesNotMove();
    void productionFilm_growingBeforeContact_growsAboutItsMiddle();
    void productionFilm_growingPinnedAtOneSide_growsAwayFromThatSide();
    void productionFilm_growingPinnedAtTwoSides_growsAcross();
    void productionFilm_pinnedEdge_holds();
    void productionFilm_smallFirstContact_doesNotRotateTheFilm();
    void productionFilm_bodyFarFromOrigin_isTheSame();
    void productionFilm_pastOverhang_releasesFilm();
    void productionFilm_pastEquator_matchesClosedForm();
};

void ProductionFilmTest::productionFilm_finerGridOrShorterStep_changeLittle() {
    const Body body = bodyOf(sphereMesh(35, 256, 512));
    const solver::DipSetup setup = squareDip(body, 86, 30);
    const Ending plain = dipOnCpu(setup);
    const double spacing = difference(plain, dipOnCpu(squareDip(body, 171, 30)), 2).first;
    solver::DipSetup shorter = setup;
    shorter.settings.contactTravel /= 2;
    const double step = difference(plain, dipOnCpu(shorter), 1).first;
    qInfo("half the spacing: %g mm, half the step: %g mm (95 %%)", spacing, step);
    // Every step ends in equilibrium, without film that did not converge.
    QCOMPARE(plain.equilibrium.stepsWithout, std::int64_t(0));
    QVERIFY(plain.equilibrium.linearIterations > 0);
    QCOMPARE(plain.marked(solver::PointMark::Unbalanced), std::size_t(0));
    QVERIFY(spacing < 0.15);
    QVERIFY(step < 0.05);
}

void ProductionFilmTest::productionFilm_thinLeg_dependsLittleOnTheStep() {
    // A leg whose radius is 3.5 film cells. The film is drawn down along the leg and gathers around
    // it.
    const Body body = bodyOf(ellipsoidMesh({6, 14, 6}, 120, 96));
    const solver::DipSetup setup = squareDip(body, 86, 13);
    solver::DipSetup shorter = setup;
    shorter.settings.contactTravel /= 2;
    const auto [percentile95, largest] = difference(dipOnCpu(setup), dipOnCpu(shorter), 1);
    qInfo("half the step: 95 %% within %g mm, all within %g mm", percentile95, largest);
    QVERIFY(percentile95 < 0.05);
}

void ProductionFilmTest::productionFilm_secondContact_dependsLittleOnTheStep() {
    // The second ball touches film that the first ball has drawn in. The first ball releases the
    // film before the end.
    const Body body = bodyOf(twoBalls());
    const solver::DipSetup setup = squareDip(body, 86, 36);
    solver::DipSetup shorter = setup;
    shorter.settings.contactTravel /= 2;
    const Ending plain = dipOnCpu(setup);
    const double step = difference(plain, dipOnCpu(shorter), 1).first;
    const double spacing = difference(plain, dipOnCpu(squareDip(body, 171, 36)), 2).first;
    qInfo("half the spacing: %g mm, half the step: %g mm (95 %%)", spacing, step);
    QVERIFY(step < 0.05);
    QVERIFY(spacing < 0.15);
}

void ProductionFilmTest::productionFilm_anyNumberOfThreads_giveTheSameBits() {
    const Body body = bodyOf(sphereMesh(35, 64, 128));
    solver::DipSetup setup = squareDip(body, 141, 20);
    setup.settings.threads = 1;
    const Ending one = dipOnCpu(setup);
    for (const int threads : {2, 5}) {
        setup.settings.threads = threads;
        const Ending more = dipOnCpu(setup);
        QVERIFY(one.states == more.states);
        QCOMPARE(std::memcmp(one.positions.data(), more.positions.data(),
                             one.positions.size() * sizeof(float)),
                 0);
    }
}

void ProductionFilmTest::productionFilm_withoutGrowth_givesTheSameBits() {
    const Body body = bodyOf(sphereMesh(35, 64, 128));
    solver::DipSetup setup = squareDip(body, 71, 20);
    const Ending plain = dipOnCpu(setup);
    for (const auto& [rate, limit] : {std::pair{0.01, 0.0}, {0.0, 0.2}}) {
        setup.settings.growthRate = rate;
        setup.settings.growthLimit = limit;
        const Ending same = dipOnCpu(setup);
        QVERIFY(plain.states == same.states);
        QVERIFY(plain.positions == same.positions);
    }
}

// At the end, free film is 1 + limit·(1 − exp(−rate·t/limit)) times as long as at the start.
void ProductionFilmTest::productionFilm_growingBeforeContact_growsAboutItsMiddle() {
    const Body body = bodyOf(sphereMesh(35, 64, 128));
    for (const double relaxationTime : {0.0, 2.0, std::numeric_limits<double>::infinity()}) {
        solver::DipSetup setup = squareDip(body, 71, 20);
        setup.motion.start[1] += 25;
        setup.settings.relaxationTime = relaxationTime;
        setup.settings.growthRate = 0.02;
        setup.settings.growthLimit = 0.2;
        const Ending ending = dipOnCpu(setup);
        const double seconds = setup.motion.travel / setup.motion.speed;
        const double grown = 1 + 0.2 * (1 - std::exp(-0.02 * seconds / 0.2));
        QVERIFY(grown > 1.05);
        for (std::size_t point = 0; point < ending.states.size(); ++point) {
            QVERIFY(ending.states[point] == solver::PointState::Free);
            const Eigen::Vector3d rest(setup.film.restX(int(point % 71)), 0,
                                       setup.film.restZ(int(point / 71)));
            QVERIFY((ending.at(point) - grown * rest).norm() < 0.01);
        }
    }
}

// Far from its pinned side, the film is as long and as wide as free film. It has moved away from
// the pinned side.
void ProductionFilmTest::productionFilm_growingPinnedAtOneSide_growsAwayFromThatSide() {
    const Body body = bodyOf(sphereMesh(15, 64, 128));
    for (const double relaxationTime : {0.0, 2.0, std::numeric_limits<double>::infinity()}) {
        const solver::DipSetup setup = growingStrip(body, relaxationTime, false);
        const Ending ending = dipOnCpu(setup);
        const double grown = grownAtTheEnd(setup);
        const std::size_t middle = 20 * 121;
        QVERIFY(grown > 1.05);
        QVERIFY(std::abs((ending.at(middle + 120).x() - ending.at(middle + 90).x()) / 60 - grown) <
                1e-4);
        QVERIFY(std::abs((ending.at(40 * 121 + 105).z() - ending.at(105).z()) / 80 - grown) < 1e-4);
        for (std::size_t row = 0; row < 41; ++row) {
            QVERIFY(std::abs(ending.at(row * 121).x() + 120) < 1e-4);
        }
    }
}

// Between two pinned sides, the film is compressed along x. It grows more across, where it has no
// stress. If free film were g times as long, elastic film is (4g − λx)/3 times as wide, and viscous
// film (g⁴/λx)^(1/3) times (docs/film-model.md, "Closed forms": the horizontal cylinder, where λx
// is 1).
void ProductionFilmTest::productionFilm_growingPinnedAtTwoSides_growsAcross() {
    const Body body = bodyOf(sphereMesh(15, 64, 128));
    for (const double relaxationTime : {0.0, std::numeric_limits<double>::infinity()}) {
        const solver::DipSetup setup = growingStrip(body, relaxationTime, true);
        const Ending ending = dipOnCpu(setup);
        const double grown = grownAtTheEnd(setup);
        const std::size_t middle = 20 * 121 + 60;
        const double along = (ending.at(middle + 5).x() - ending.at(middle - 5).x()) / 20;
        const double width = (ending.at(40 * 121 + 60).z() - ending.at(60).z()) / 80;
        const double expected =
            relaxationTime == 0 ? std::cbrt(std::pow(grown, 4) / along) : (4 * grown - along) / 3;
        qInfo("relaxation %g s: %.6f along, %.6f across for %.6f", relaxationTime, along, width,
              expected);
        QVERIFY(std::abs(along - 1) < 0.01);
        QVERIFY(std::abs(width - expected) < 2e-4);
        QVERIFY(std::abs(ending.at(middle).x()) < 1e-3);
    }
}

void ProductionFilmTest::productionFilm_beforeContact_doesNotMove() {
    const Body body = bodyOf(sphereMesh(35, 64, 128));
    solver::DipSetup setup = squareDip(body, 61, 10);
    setup.motion.travel = 0.4; // the body's lowest point starts 0.5 mm above the water
    const Ending ending = dipOnCpu(setup);
    for (std::size_t point = 0; point < ending.states.size(); ++point) {
        QVERIFY(ending.states[point] == solver::PointState::Free);
        const double x = -75 + double(point % 61) * 2.5, z = -75 + double(point / 61) * 2.5;
        QVERIFY((ending.at(point) - Eigen::Vector3d(x, 0, z)).norm() < 1e-5);
        QCOMPARE(ending.marks[point], std::uint8_t(0));
    }
    QCOMPARE(ending.equilibrium.linearIterations, std::int64_t(0));
}

void ProductionFilmTest::productionFilm_pinnedEdge_holds() {
    const Body body = bodyOf(sphereMesh(35, 64, 128));
    solver::DipSetup setup = squareDip(body, 61, 30);
    setup.pinned.assign(setup.film.pointCount(), 0);
    for (std::size_t row = 0; row < 61; ++row) {
        setup.pinned[row * 61] = 1; // the left side
    }
    const Ending ending = dipOnCpu(setup);
    double rightMoved = 0;
    for (std::size_t row = 0; row < 61; ++row) {
        QVERIFY(std::abs(ending.at(row * 61).x() + 75) < 1e-4);
        rightMoved = std::max(rightMoved, 75 - ending.at(row * 61 + 60).x());
    }
    QVERIFY(rightMoved > 0.5);
}

void ProductionFilmTest::productionFilm_smallFirstContact_doesNotRotateTheFilm() {
    // A horn three cells wide, oblique to the grid but with a plane of symmetry. So the horn itself
    // does not rotate the film.
    Immersion askew;
    askew.rotation = {Degrees(12), Degrees(25), Degrees(0)};
    askew.offset = {Millimetres(0.7), Millimetres(-0.4)};
    const TriangleMesh horn = ellipsoidMesh({3, 24, 2.5}, 60, 80);
    const PosedBody posed = posedBody(horn, askew);
    const DistanceField own = buildDistanceField(horn, 128, {});
    const FilledField field(posed, own);
    FilmSettings film;
    film.width = film.height = Millimetres(150);
    film.columns = film.rows = 81;
    ProcessSettings process;
    process.depth = Millimetres(5);
    const Ending end = dipOnCpu(dipSetup(posed, field, askew, film, process));
    double turn = 0; // degrees, mean rotation of the corners about the film's middle
    for (const std::size_t corner : {0, 80, 80 * 81, 81 * 81 - 1}) {
        const Eigen::Vector2d rest = restPosition(end.setup.film, corner).cast<double>();
        const Eigen::Vector2d now(end.at(corner).x(), end.at(corner).z());
        turn += std::atan2(rest.x() * now.y() - rest.y() * now.x(), rest.dot(now)) * 45 / pi;
    }
    qInfo("turned by %g degrees", turn);
    QVERIFY(std::abs(turn) < 0.5);
}

// Solvers compute with floats, so they see a far body in coordinates near the origin.
void ProductionFilmTest::productionFilm_bodyFarFromOrigin_isTheSame() {
    FilmSettings film;
    film.width = film.height = Millimetres(90);
    film.columns = film.rows = 61;
    Immersion straight;
    straight.rotation = {Degrees(12), Degrees(25), Degrees(0)};
    Immersion tilted = straight;
    tilted.path.kind = PathKind::Tilt;
    tilted.path.angle = Degrees(20);
    const auto filmAt = [&](const Eigen::Vector3f& place, const Immersion& immersion) {
        TriangleMesh mesh = ellipsoidMesh({20, 16, 24}, 32, 64);
        for (Eigen::Vector3f& position : mesh.positions) {
            // Every place is then exact 100 m away.
            position = (position * 64).array().round().matrix() / 64 + place;
        }
        const PosedBody posed = posedBody(mesh, immersion, ProcessSettings());
        const DistanceField own = buildDistanceField(mesh, 64, {});
        const FilledField field(posed, own);
        solver::BatchItem item;
        item.setup = dipSetup(posed, field, immersion, film, {});
        const Ending ending = dipOnCpu(item.setup);
        item.positions = ending.positions;
        item.states = ending.states;
        return dippedFilm(item, immersion);
    };
    for (const Immersion& immersion : {straight, tilted}) {
        const DippedFilm near = filmAt({0, 0, 0}, immersion);
        QVERIFY(near.adheresAnywhere());
        for (const float away : {2300.f, 10'000.f, 100'000.f}) {
            const DippedFilm far = filmAt({away, away / 4, -away / 2}, immersion);
            double most = 0;
            for (std::size_t point = 0; point < near.states.size(); ++point) {
                most =
                    std::max(most, double((far.positions[point] - near.positions[point]).norm()));
            }
            qInfo("%g m away: %g mm", double(away) / 1000, most);
            QVERIFY(far.states == near.states);
            QVERIFY(most < 0.01);
        }
    }
}

void ProductionFilmTest::productionFilm_pastOverhang_releasesFilm() {
    const Body body = bodyOf(sphereMesh(35, 64, 128));
    const Ending ending = dipOnCpu(squareDip(body, 91, 72));  // all of it under water
    const double highest = 35 + 35 * std::sin(20 * pi / 180); // mm above the lowest point
    int adhered = 0;
    for (std::size_t point = 0; point < ending.states.size(); ++point) {
        if (ending.adhered(point)) {
            ++adhered;
            QVERIFY(ending.at(point).y() - startHeight + ending.descent < highest + 0.3);
        }
    }
    QVERIFY(adhered > 500);
    // The film that was released at the overhang is marked. It is a small part of the film.
    const std::size_t releasedPoints = ending.marked(solver::PointMark::LetGo);
    QVERIFY(releasedPoints > 20 && releasedPoints < ending.marks.size() / 10);
}

// Past the equator, the body's grip on the film fades (Adhesion.h). The body is a sphere of 35 mm
// in a film that is pinned at a ring of 90 mm. The closed form is that of docs/film-model.md,
// "Closed forms", with the rate at which film is laid:
//   dR/ds = (g + (1 − g) da/ds)/λr, and da/ds = −u, where u is the y component of the body's
// normal.
void ProductionFilmTest::productionFilm_pastEquator_matchesClosedForm() {
    constexpr double rho = 35, ring = 90;
    const Body body = bodyOf(sphereMesh(rho, 180, 360));
    FilmSettings film;
    film.width = film.height = Millimetres(2 * ring + 4);
    film.columns = film.rows = 185;
    ProcessSettings process;
    process.depth = Millimetres(2 * rho + 2);
    solver::DipSetup setup = dipSetup(body.posed, body.field, Immersion{}, film, process);
    setup.pinned.assign(setup.film.pointCount(), 0);
    for (std::size_t point = 0; point < setup.pinned.size(); ++point) {
        setup.pinned[point] = restPosition(setup.film, point).norm() >= float(ring);
    }
    const Ending ending = dipOnCpu(setup);

    const double overhang = radians(process.overhang);
    const auto held = numerics::contactBody<double>(setup);
    const auto slope = [&](double theta, double R) {
        const double u = -std::cos(theta);
        const double g =
            std::clamp((held.steepestHeld - u) / (held.steepestHeld - held.firmlyHeld), 0.0, 1.0);
        const double A = (rho * std::sin(theta) - R) / (R - ring * ring / R);
        return rho * (g - (1 - g) * u) / (1 + A + A * ring * ring / (R * R));
    };
    constexpr double step = 1e-4;
    std::vector<double> radius{0, rho * step};
    for (double theta = step; theta < pi / 2 + overhang; theta += step) {
        const double R = radius.back();
        radius.push_back(R + step * slope(theta + step / 2, R + step / 2 * slope(theta, R)));
    }
    // No film is laid at the overhang.
    QVERIFY(std::abs(slope(pi / 2 + overhang, radius.back())) < 0.01 * rho);

    double worst = 0, farthest = 0;
    for (std::size_t point = 0; point < ending.states.size(); ++point) {
        if (!ending.adhered(point)) {
            continue;
        }
        const double height = ending.at(point).y() - startHeight + ending.descent - rho;
        const double theta = pi / 2 + std::asin(std::clamp(height / rho, -1.0, 1.0));
        farthest = std::max(farthest, theta);
        if (theta > pi / 2) {
            const double R = double(restPosition(setup.film, point).norm());
            worst = std::max(worst, std::abs(R - radius[std::size_t(theta / step)]));
        }
    }
    qInfo("past the equator: %.3f mm at most; film to %.1f°", worst,
          (farthest - pi / 2) * 180 / pi);
    QVERIFY(worst < 0.3);                              // mm; the film's radius is 47 mm
    QVERIFY(farthest < pi / 2 + overhang + 0.3 / rho); // does not exceed the overhang
    QVERIFY(farthest > pi / 2 + 0.6 * overhang);       // comes near the overhang
}

QTEST_GUILESS_MAIN(ProductionFilmTest)
#include "ProductionFilmTest.moc"

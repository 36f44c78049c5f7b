// Compares the production film under bodies that tilt, travel, roll and turn with closed forms
// (docs/film-model.md, "Paths").
#include "WholeSample.h"
#include "geometry/DistanceField.h"
#include "geometry/Shapes.h"
#include "production/cpu/ProductionFilm.h"
#include "production/reference/ReferenceFilm.h"

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <functional>
#include <numbers>

using namespace dipwright;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double gap = 0.2; // height of the body over the water at the beginning, mm

struct Pose {
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    Eigen::Vector3d pivot;
};
using PoseAt = std::function<Pose(double share)>;

// Returns a path of `parts` parts for a body whose farthest point is `radius` from the pivot, which
// is the origin of the body's coordinates.
solver::BodyPath pathOf(const PoseAt& poseAt, int parts, double radius, double seconds) {
    solver::BodyPath path;
    Pose before = poseAt(0);
    double travelled = 0;
    for (int part = 0; part <= parts; ++part) {
        const Pose now = poseAt(double(part) / parts);
        travelled +=
            (now.pivot - before.pivot).norm() + radius * now.turn.angularDistance(before.turn);
        path.poses.push_back({travelled,
                              seconds * part / parts,
                              {now.turn.w(), now.turn.x(), now.turn.y(), now.turn.z()},
                              {now.pivot.x(), now.pivot.y(), now.pivot.z()}});
        before = now;
    }
    return path;
}

// A dip and its result.
struct Dip {
    TriangleMesh mesh;
    DistanceField field;
    solver::DipSetup setup;
    std::vector<float> positions; // in the world
    std::vector<solver::PointState> states;

    explicit Dip(TriangleMesh body, int resolution = 160)
        : mesh(std::move(body)), field(buildDistanceField(mesh, resolution, {})) {
        setup.field.distance = field.distance.data();
        setup.field.size = field.size;
        setup.field.origin = {field.origin.x(), field.origin.y(), field.origin.z()};
        setup.field.spacing = field.spacing;
        setup.settings.relaxationTime = std::numeric_limits<double>::infinity();
        setup.settings.contactTravel = 0.25;
    }

    void layFilm(double width, double depth, double spacing) {
        solver::FilmGrid& film = setup.film;
        film.columns = 2 * int(std::lround(width / 2 / spacing)) + 1;
        film.rows = 2 * int(std::lround(depth / 2 / spacing)) + 1;
        film.width = spacing * (film.columns - 1);
        film.depth = spacing * (film.rows - 1);
    }
    template <typename IsHeld>
    void pin(const IsHeld& isHeld) {
        setup.pinned.clear();
        for (std::size_t point = 0; point < setup.film.pointCount(); ++point) {
            setup.pinned.push_back(isHeld(rest(point)) ? 1 : 0);
        }
    }
    Eigen::Vector2d rest(std::size_t point) const {
        const auto columns = std::size_t(setup.film.columns);
        return {setup.film.restX(int(point % columns)), setup.film.restZ(int(point / columns))};
    }
    void follow(solver::BodyPath path) {
        setup.motion.travel = path.poses.back().travelled;
        setup.path = std::move(path);
    }
    void run(std::unique_ptr<solver::FilmSolver> film = cpu::makeProductionFilm()) {
        film->begin(setup);
        while (!film->advance(64).finished) {
        }
        positions.resize(3 * setup.film.pointCount());
        states.resize(setup.film.pointCount());
        film->read(positions, states);
    }
    bool adhered(std::size_t point) const { return states[point] == solver::PointState::Adhered; }
    // Returns the place on the body, in its coordinates.
    Eigen::Vector3d onBody(std::size_t point) const {
        const solver::PathPose& end = setup.path.poses.back();
        const Eigen::Quaterniond turn(end.rotation[0], end.rotation[1], end.rotation[2],
                                      end.rotation[3]);
        return turn.conjugate() *
               (Eigen::Map<const Eigen::Vector3f>(&positions[3 * point]).cast<double>() -
                Eigen::Map<const Eigen::Vector3d>(end.pivot.data()));
    }
};

// Compares values with those of a closed form that is known up to a constant.
struct Comparison {
    std::vector<double> off;
    void add(double value, double expected) { off.push_back(value - expected); }
    double rms() const {
        double sum = 0, squares = 0;
        for (const double one : off) {
            sum += one;
        }
        const double mean = sum / double(off.size());
        for (const double one : off) {
            squares += (one - mean) * (one - mean);
        }
        return std::sqrt(squares / double(off.size()));
    }
};

Eigen::Quaterniond turnAbout(const Eigen::Vector3d& axis, double angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

#define VERIFY_AT_MOST(value, most)                                                                \
    QVERIFY2((value) <= (most),                                                                    \
             qPrintable(QStringLiteral("%1, expected at most %2").arg(value).arg(most)))

} // namespace

class PathClosedFormTest : public QObject {
    Q_OBJECT

private slots:
    // The same motion as a path and as a straight dip.
    void path_straightDown_equalsTheStraightDip() {
        Dip straight(sphereMesh(20, 60, 120), 96);
        straight.layFilm(120, 120, 2);
        straight.setup.motion.start = {0, 20 + gap, 0};
        straight.setup.motion.travel = gap + 18;
        straight.setup.settings.relaxationTime = 4;
        Dip path = straight;
        path.setup.field.distance = path.field.distance.data();
        path.follow(pathOf(
            [](double share) {
                return Pose{Eigen::Quaterniond::Identity(), {0, 20 + gap - share * (gap + 18), 0}};
            },
            3, 20, (gap + 18) / straight.setup.motion.speed));
        straight.run();
        path.run();
        QCOMPARE(path.states, straight.states);
        double most = 0;
        for (std::size_t i = 0; i < path.positions.size(); ++i) {
            most = std::max(most, double(std::abs(path.positions[i] - straight.positions[i])));
        }
        qInfo("farthest %g mm", most);
        VERIFY_AT_MOST(most, 2e-3);
    }

    // An inclined plate that is levelled while it goes down: the film is laid from the entering
    // edge on, without stretch, so film and plate have the same distances from it.
    void plate_tiltedInAndLevelled_filmKeepsItsLengths() {
        const double length = 60, thickness = 6, tilt = 25 * pi / 180, down = 30;
        Dip dip(boxMesh({length, thickness, 40}));
        dip.layFilm(120, 30, spacing()); // narrower than the plate, so that it hangs over no edge
        const auto poseAt = [&](double share) {
            // The side towards +X enters first and is level after 60 % of the travel.
            const double angle = tilt * std::max(0.0, 1 - share / 0.6);
            const double below = length / 2 * std::sin(angle) + thickness / 2 * std::cos(angle);
            return Pose{turnAbout(-Eigen::Vector3d::UnitZ(), angle),
                        {0, below + gap - share * down, 0}};
        };
        dip.follow(pathOf(poseAt, 60, 37, 6));
        dip.run();
        Comparison along, across;
        for (std::size_t point = 0; point < dip.states.size(); ++point) {
            const Eigen::Vector3d place = dip.onBody(point);
            const bool isBelow = dip.adhered(point) && place.y() < -thickness / 2 + 0.1 &&
                                 std::abs(place.x()) < 0.45 * length;
            if (isBelow) {
                along.add(place.x(), dip.rest(point).x());
                across.add(place.z(), dip.rest(point).y());
            }
        }
        qInfo("%zu points: %g mm along, %g mm across", along.off.size(), along.rms(), across.rms());
        QVERIFY(along.off.size() > 100);
        VERIFY_AT_MOST(along.rms(), 0.02);
        VERIFY_AT_MOST(across.rms(), 0.02);
    }

    // A cylinder that rolls over the film without slip wears it without stretch, round more than
    // 300°. A straight dip paints under 200°.
    void cylinder_rolledWithoutSlip_filmKeepsItsLengths() {
        const double radius = 20, deep = 5, roll = 320 * pi / 180;
        Dip dip(cylinderMesh(radius, 50, 240));
        const double way = radius * roll;
        dip.layFilm(2 * (way + 20), 30, spacing());
        // Starts near the film's left edge and rolls towards +X.
        const double start = -way / 2;
        const double sink = gap + deep;
        const double all = sink + way;
        const auto poseAt = [&](double share) {
            const double done = share * all;
            const double rolled = std::max(0.0, done - sink) / radius;
            return Pose{turnAbout(-Eigen::Vector3d::UnitZ(), rolled),
                        {start + radius * rolled, radius + gap - std::min(done, sink), 0}};
        };
        dip.follow(pathOf(poseAt, 200, 32.1, all / 5));
        dip.run();
        Comparison along;
        double least = 1e9, most = -1e9;
        for (std::size_t point = 0; point < dip.states.size(); ++point) {
            const Eigen::Vector3d place = dip.onBody(point);
            const Eigen::Vector2d rest = dip.rest(point);
            const bool isAhead =
                dip.adhered(point) && rest.x() > start + 12 && rest.x() < start + way - 5;
            if (isAhead) {
                // Angle from the line that touched the water first, in the direction of the film.
                double angle = std::atan2(place.x(), -place.y());
                const double expected = (rest.x() - start) / radius;
                angle += 2 * pi * std::round((expected - angle) / (2 * pi));
                along.add(radius * angle, rest.x());
                least = std::min(least, angle);
                most = std::max(most, angle);
            }
        }
        qInfo("%zu points: %g mm along, %.1f° of the cylinder", along.off.size(), along.rms(),
              (most - least) * 180 / pi);
        QVERIFY(along.off.size() > 100);
        VERIFY_AT_MOST(along.rms(), 0.02);
    }

    // A narrow film is held at its far edge, and the cylinder rolls farther than it travels. So it
    // stretches the film between itself and the edge by λ = (E − x) / (E − R), if E is the edge, x
    // the contact line and R the rest place of the film there. Where the arc grows by ds, the film
    // that is laid has the rest length ds / λ.
    void cylinder_rolledWithSlip_filmIsStretchedByTheClosedForm() {
        const double radius = 20, deep = 4, roll = 120 * pi / 180, k = 0.8;
        Dip dip(cylinderMesh(radius, 50, 240));
        const double way = k * radius * roll, start = -30, edge = 60;
        dip.layFilm(2 * edge, 16, spacing());
        dip.pin([&](const Eigen::Vector2d& rest) { return rest.x() > edge - 0.1; });
        const double sink = gap + deep, all = sink + way;
        dip.follow(pathOf(
            [&](double part) {
                const double done = part * all, gone = std::max(0.0, done - sink);
                return Pose{turnAbout(-Eigen::Vector3d::UnitZ(), gone / (k * radius)),
                            {start + gone, radius + gap - std::min(done, sink), 0}};
            },
            120, 32.1, all / 5));
        dip.run();
        const double entry = std::acos((radius - deep) / radius); // angle of the contact line
        const auto arcOf = [&](double rest) {
            constexpr double step = 1e-3;
            double arc = 0;
            for (double laid = start; laid < rest; arc += step) {
                const double sunk = std::min(arc / radius, entry);
                const double line = start + radius * std::sin(sunk) + k * (arc - radius * sunk);
                laid += step * (edge - laid) / (edge - line);
            }
            return arc;
        };
        Comparison along;
        for (std::size_t point = 0; point < dip.states.size(); ++point) {
            const Eigen::Vector3d place = dip.onBody(point);
            double angle = std::atan2(place.x(), -place.y());
            angle += angle < -1 ? 2 * pi : 0;
            if (dip.adhered(point) && std::abs(place.z()) < 4 && angle > entry + 0.1) {
                along.add(radius * angle, arcOf(dip.rest(point).x()));
            }
        }
        qInfo("%zu points: %g mm along", along.off.size(), along.rms());
        QVERIFY(along.off.size() > 100);
        VERIFY_AT_MOST(along.rms(), 0.02);
    }

    // A cone of 45° that turns while it goes down, in a viscous film held at a ring:
    // docs/film-model.md derives the flow. The film is twisted against the cone.
    void cone_turnedWhileItSinks_filmIsTwistedByTheClosedForm() {
        const double half = pi / 4, height = 30, ring = 90, twist = 40 * pi / 180;
        Dip dip(coneMesh(half, height, 240), 192);
        dip.layFilm(2 * ring + 8, 2 * ring + 8, test::isWholeRun() ? 0.5 : 1);
        dip.pin([&](const Eigen::Vector2d& rest) { return rest.norm() >= ring; });
        dip.setup.settings.relaxationTime = 0;
        const double down = 26;
        dip.follow(pathOf(
            [&](double share) {
                return Pose{turnAbout(Eigen::Vector3d::UnitY(), twist * share),
                            {0, gap - share * (gap + down), 0}};
            },
            40, 42.5, 6));
        dip.run();
        // Integrates the film's flow for a ring of film points from the first contact to its own.
        const double q = 1 / std::sin(half) - 1;
        const double perRadius = twist / (gap + down) / std::tan(half); // turn per mm of radius
        const auto laidAt = [&](double rest) {
            double x = rest, angle = 0, a = 1e-6;
            const double step = 1e-3;
            while (a < x) {
                const double b = 1 / (1 / a - a / (ring * ring));
                angle += step * perRadius * a * (1 / (x * x) - 1 / (ring * ring)) * b;
                x -= step * q * (1 / x - x / (ring * ring)) * b;
                a += step;
            }
            return std::pair(x, angle - perRadius * a - twist * gap / (gap + down));
        };
        // The film at the tip is as fine as a cell only, so all film may be turned a little.
        std::vector<double> radii, angles;
        double radial = 0, mean = 0;
        for (std::size_t point = 0; point < dip.states.size(); ++point) {
            const Eigen::Vector2d rest = dip.rest(point);
            if (!dip.adhered(point) || rest.norm() < 5 || rest.norm() > 26) {
                continue;
            }
            const auto [radius, angle] = laidAt(rest.norm());
            const Eigen::Vector3d place = dip.onBody(point);
            // Angles about +Y, counterclockwise seen from above.
            const double onBody = std::atan2(-place.z(), place.x());
            const double onFilm = std::atan2(-rest.y(), rest.x());
            radii.push_back(radius);
            angles.push_back(std::remainder(onBody - onFilm - angle, 2 * pi));
            mean += angles.back();
            radial += std::pow(std::hypot(place.x(), place.z()) - radius, 2);
        }
        const auto count = double(radii.size());
        QVERIFY(count > 1000);
        mean /= count;
        radial = std::sqrt(radial / count);
        double around = 0;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            around += std::pow(radii[i] * (angles[i] - mean), 2);
        }
        around = std::sqrt(around / count);
        qInfo("%g points: %g mm around, %g mm along the radius, all turned by %g°", count, around,
              radial, mean * 180 / pi);
        VERIFY_AT_MOST(around, 0.013); // 0.05 % of the travel
        VERIFY_AT_MOST(radial, 0.013);
        VERIFY_AT_MOST(std::abs(mean), 0.01);
    }

    // A sphere on a slanted way takes a free film along. If it touches the film at the same place,
    // it wears the same as after a straight dip.
    void sphere_onASlantedWay_wearsTheSameAsStraightDown() {
        const double radius = 20, down = 18, aside = 15;
        const auto dipped = [&](double sideways) {
            Dip dip(sphereMesh(radius, 80, 160));
            dip.layFilm(140, 140, test::isWholeRun() ? 0.33 : 0.7);
            dip.follow(pathOf(
                [&](double share) {
                    return Pose{Eigen::Quaterniond::Identity(),
                                {sideways * (share - gap / (gap + down)),
                                 radius + gap - share * (gap + down), 0}};
                },
                2, radius, 4));
            dip.run();
            return dip;
        };
        const Dip straight = dipped(0), slanted = dipped(aside);
        Comparison x, z;
        for (std::size_t point = 0; point < straight.states.size(); ++point) {
            if (straight.adhered(point) && slanted.adhered(point)) {
                x.add(slanted.onBody(point).x(), straight.onBody(point).x());
                z.add(slanted.onBody(point).z(), straight.onBody(point).z());
            }
        }
        qInfo("%zu points: %g mm in the direction of travel, %g mm across", x.off.size(), x.rms(),
              z.rms());
        VERIFY_AT_MOST(x.rms(), 0.0005 * std::hypot(down, aside));
        VERIFY_AT_MOST(z.rms(), 0.0005 * std::hypot(down, aside));
    }

    // The reference solver follows the same paths.
    void referenceFilm_onAPath_agreesWithTheCpu() {
        Dip one(cylinderMesh(10, 20, 80), 64);
        one.layFilm(60, 16, 2);
        one.follow(pathOf(
            [&](double share) {
                return Pose{turnAbout(-Eigen::Vector3d::UnitZ(), share),
                            {10 * share, 10 + gap - std::min(1.0, 3 * share) * (gap + 4), 0}};
            },
            12, 14.2, 3));
        Dip other = one;
        other.setup.field.distance = other.field.distance.data();
        one.run();
        other.run(reference::makeReferenceFilm());
        double most = 0;
        for (std::size_t i = 0; i < one.positions.size(); ++i) {
            most = std::max(most, double(std::abs(one.positions[i] - other.positions[i])));
        }
        qInfo("farthest %g mm", most);
        QCOMPARE(one.states, other.states);
        VERIFY_AT_MOST(most, 0.01);
    }

private:
    static double spacing() { return test::isWholeRun() ? 0.5 : 1.0; }
};

QTEST_GUILESS_MAIN(PathClosedFormTest)
#include "PathClosedFormTest.moc"

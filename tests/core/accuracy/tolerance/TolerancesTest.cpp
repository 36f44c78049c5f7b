// Tests how far colours land from their places for given handling errors, in cases with known
// results.
#include "DippedByHand.h"
#include "TestFolders.h"
#include "geometry/Shapes.h"
#include "parallel/Threads.h"
#include "pipeline/JobTolerances.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"

#include <QJsonArray>
#include <QStandardPaths>
#include <QtTest>

#include <numeric>

using namespace dipwright;

namespace {

constexpr double radius = 25; // radius of the ball, mm
constexpr double percent = 0.01;

ToleranceSettings exact() {
    ToleranceSettings none;
    none.position = none.filmPosition = {Millimetres(0), Millimetres(0)};
    none.turn = {Degrees(0), Degrees(0), Degrees(0)};
    none.filmTurn = Degrees(0);
    none.swell = none.speed = none.relaxation = 0;
    none.waterLevel = Millimetres(0);
    none.pathAngle = Degrees(0);
    none.timing = Seconds(0);
    none.samples = 0;
    return none;
}

Project jobOf(const TriangleMesh& mesh, double film, int points) {
    Project project;
    project.model =
        std::make_shared<const TexturedMesh>(test::plainModel(mesh, QColor(200, 200, 200)));
    project.film.width = project.film.height = Millimetres(film);
    project.film.columns = project.film.rows = points;
    project.fieldResolution = 96;
    project.sheet.resolution = DotsPerInch(40);
    return project;
}

// Returns a project with a box whose flat bottom touches the film all at once and does not deform
// the film.
Project box() {
    Project project = jobOf(boxMesh({60, 20, 40}), 100, 51);
    project.process.depth = Millimetres(1);
    return project;
}

Project ball() {
    return jobOf(sphereMesh(radius, 60, 120), 160, 65);
}

const SolverRegistry& registry() {
    static const SolverRegistry plugins{QStringList{pluginFolder()}};
    return plugins;
}

JobResult resultOf(const Project& project) {
    JobOptions options;
    options.estimatesNumericalError = false;
    return runJob(project, registry(), options, nullptr, {});
}

DipTolerances tolerances(const JobResult& result, const ToleranceSettings& settings) {
    return jobTolerances(result, settings, registry(), {}).dips.front();
}

// Calls `look` with each place of the box's bottom that is at least one cell from the bottom's
// edges, in model coordinates.
template <typename Look>
void eachOfTheBottom(const JobResult& result, const DipTolerances& found, const Look& look) {
    const TexturedMesh& model = *result.project.model;
    const std::vector<SurfacePoint> places = tolerancePlaces(model);
    int looked = 0;
    for (std::size_t place = 0; place < places.size(); ++place) {
        const Eigen::Vector3f at = position(model.mesh, places[place]);
        if (at.y() < -9.99f && std::abs(at.x()) < 27 && std::abs(at.z()) < 17) {
            look(Eigen::Vector2d(double(at.x()), double(at.z())), double(found.places[place]));
            ++looked;
        }
    }
    QVERIFY(looked > 5000);
}

// Returns a pose of a path by poses: time in s, depth in mm, and turn about Z in degrees.
PathKey key(double seconds, std::optional<double> depth, double turn) {
    PathKey key;
    key.time = Seconds(seconds);
    key.depth = depth ? std::optional(Millimetres(*depth)) : std::nullopt;
    key.turn[2] = Degrees(turn);
    return key;
}

// Returns a job in which the box goes down at an angle to the water, in degrees.
Project slantedBox(double angle) {
    Project slanted = box();
    slanted.immersions.front().path.kind = PathKind::Slanted;
    slanted.immersions.front().path.angle = Degrees(angle);
    return slanted;
}

#define VERIFY_NEAR(value, wanted, allowed)                                                        \
    QVERIFY2(std::abs((value) - (wanted)) <= (allowed),                                            \
             qPrintable(QStringLiteral("%1, expected %2").arg(value).arg(wanted)))

} // namespace

class TolerancesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        box_ = resultOf(box());
        ball_ = resultOf(ball());
    }

    void jobTolerances_positionOverFlatBottom_movesColoursByAsMuch() {
        ToleranceSettings settings = exact();
        settings.position = {Millimetres(0.6), Millimetres(0.8)};
        eachOfTheBottom(box_, tolerances(box_, settings),
                        [](auto, double spread) { VERIFY_NEAR(spread, 1.0, 1e-3); });
    }

    void jobTolerances_squareUnderflows_givesZeroSpread() {
        ToleranceSettings settings = exact();
        settings.position[0] = Millimetres(1e-300);
        settings.swell = 1e-200;
        eachOfTheBottom(box_, tolerances(box_, settings),
                        [](auto, double spread) { QCOMPARE(spread, 0.0); });
    }

    void jobTolerances_filmPosition_equalsTheSameBodyPosition() {
        ToleranceSettings film = exact(), body = exact();
        film.filmPosition = body.position = {Millimetres(0.5), Millimetres(0.2)};
        film.filmTurn = body.turn[1] = Degrees(0.7);
        const DipTolerances one = tolerances(ball_, film), other = tolerances(ball_, body);
        QCOMPARE(one.places, other.places);
        // A moved film changes the dip like a body that is moved in the opposite direction.
        Immersion aside;
        aside.offset = {Millimetres(20), Millimetres(-10)};
        const DipChange change = changeBy(Contributor::FilmTurn, aside);
        // If the film turns, a body beside the film's centre moves around that centre in the
        // opposite direction.
        const Eigen::Vector2d offset(20, -10);
        const double angle = pi / 180;
        VERIFY_NEAR(of(change, Freedom::TurnY), -1.0, 1e-12);
        // A right-handed turn about Y moves x to x + angle·z and z to z − angle·x.
        VERIFY_NEAR(of(change, Freedom::X), -angle * offset.y(), 1e-12);
        VERIFY_NEAR(of(change, Freedom::Z), angle * offset.x(), 1e-12);
    }

    void jobTolerances_swell_movesColoursByDistanceFromFilmCentre() {
        ToleranceSettings settings = exact();
        settings.swell = percent;
        eachOfTheBottom(box_, tolerances(box_, settings),
                        [](const Eigen::Vector2d& at, double spread) {
                            VERIFY_NEAR(spread, percent * at.norm(), 2e-3);
                        });
    }

    void jobTolerances_turnAboutVertical_movesColoursByTheArc() {
        ToleranceSettings settings = exact();
        settings.turn[1] = Degrees(1);
        eachOfTheBottom(box_, tolerances(box_, settings),
                        [](const Eigen::Vector2d& at, double spread) {
                            VERIFY_NEAR(spread, at.norm() * pi / 180, 2e-3);
                        });
    }

    // Viscous film lies at R = 2ρ sin(θ/2). A millimetre of this film becomes 1/cos(θ/2) mm along
    // the meridian and cos(θ/2) mm across it (docs/film-model.md, "Closed forms").
    void jobTolerances_positionOnBall_movesColoursByTheClosedForm() {
        Project viscous = ball();
        viscous.film.relaxationTime = Seconds(0);
        const JobResult result = resultOf(viscous);
        ToleranceSettings settings = exact();
        settings.position[0] = Millimetres(0.5);
        const DipTolerances found = tolerances(result, settings);
        const std::vector<SurfacePoint> places = tolerancePlaces(*viscous.model);
        std::vector<float> ratios;
        for (std::size_t place = 0; place < places.size(); ++place) {
            const Eigen::Vector3d at = position(viscous.model->mesh, places[place]).cast<double>();
            const double angle = std::acos(std::clamp(-at.y() / at.norm(), -1.0, 1.0));
            if (angle < 0.1 || angle > 80 * pi / 180) {
                continue;
            }
            QVERIFY(found.places[place] >= 0);
            const double along = at.x() / std::hypot(at.x(), at.z());
            const double slope = std::cos(angle / 2);
            const double wanted = 0.5 * std::sqrt(along * along / (slope * slope) +
                                                  (1 - along * along) * slope * slope);
            ratios.push_back(float(double(found.places[place]) / wanted - 1));
        }
        QVERIFY(ratios.size() > 5000);
        const double mean =
            std::accumulate(ratios.begin(), ratios.end(), 0.0) / double(ratios.size());
        VERIFY_NEAR(mean, 0.0, 0.01);
        for (float& ratio : ratios) {
            ratio = std::abs(ratio);
        }
        QVERIFY2(
            spreadOf(ratios).percentile95 < 0.05,
            qPrintable(QStringLiteral(
                           "95 % of the spreads are within %1 of the closed form, expected < 0.05")
                           .arg(spreadOf(ratios).percentile95)));
    }

    void jobTolerances_waterLevelOfSubmergedBody_movesNothing() {
        ToleranceSettings settings = exact();
        settings.waterLevel = Millimetres(1);
        const DipTolerances found = tolerances(ball_, settings);
        QVERIFY2(found.spread.maximum < 1e-3,
                 qPrintable(QStringLiteral("largest spread %1 mm, expected < 0.001 mm")
                                .arg(found.spread.maximum)));
        QVERIFY(found.contributions.front().lost < 1);
    }

    void jobTolerances_waterLevelOfHalfDippedBody_movesTheBorder() {
        Project half = ball();
        half.process.depth = Millimetres(radius * 0.6);
        ToleranceSettings settings = exact();
        settings.waterLevel = Millimetres(4); // more than a film cell
        const DipTolerances found = tolerances(resultOf(half), settings);
        const double belt = 2 * pi * radius * 4; // mm², at any height of a ball
        QVERIFY2(
            found.spread.percentile95 < 0.05,
            qPrintable(QStringLiteral("95 % of the spreads are within %1 mm, expected < 0.05 mm")
                           .arg(found.spread.percentile95)));
        VERIFY_NEAR(found.contributions.front().lost, belt, 0.2 * belt);
        VERIFY_NEAR(found.contributions.front().gained, belt, 0.2 * belt);
    }

    void jobTolerances_speedOfElasticFilm_movesNothing() {
        ToleranceSettings settings = exact();
        settings.speed = 10 * percent;
        settings.relaxation = 20 * percent;
        const DipTolerances found = tolerances(ball_, settings);
        QCOMPARE(found.spread.maximum, 0.0);
        QVERIFY(!found.sampled);
    }

    // Speed and relaxation act only through the ratio of the dip's duration to the relaxation time.
    void jobTolerances_speedAndRelaxation_haveTheSameEffect() {
        Project slow = ball();
        slow.film.relaxationTime = Seconds(5);
        const JobResult result = resultOf(slow);
        ToleranceSettings speed = exact(), relaxation = exact();
        speed.speed = relaxation.relaxation = 10 * percent;
        const double one = tolerances(result, speed).spread.percentile95;
        const double other = tolerances(result, relaxation).spread.percentile95;
        QVERIFY(one > 0.005);
        VERIFY_NEAR(one / other, 1.0, 0.05);
    }

    // The higher the water, the earlier the part meets the film, and the less far it has travelled
    // sideways by then. All other deviations have the same effect as in a straight dip, because the
    // film moves with the box as soon as they touch.
    void jobTolerances_slantedDip_movesColoursByTheClosedForms() {
        constexpr Degrees steepness(60);
        const JobResult result = resultOf(slantedBox(steepness.value()));
        ToleranceSettings level = exact();
        level.waterLevel = Millimetres(0.6);
        const double along = 0.6 / std::tan(radians(steepness));
        eachOfTheBottom(result, tolerances(result, level),
                        [&](auto, double spread) { VERIFY_NEAR(spread, along, 5e-3); });
        ToleranceSettings turn = exact();
        turn.turn[1] = Degrees(1);
        eachOfTheBottom(result, tolerances(result, turn),
                        [](const Eigen::Vector2d& at, double spread) {
                            VERIFY_NEAR(spread, at.norm() * pi / 180, 5e-3);
                        });
        ToleranceSettings position = exact();
        position.position = {Millimetres(0.6), Millimetres(0.8)};
        eachOfTheBottom(result, tolerances(result, position),
                        [](auto, double spread) { VERIFY_NEAR(spread, 1.0, 5e-3); });
        // From 0.5 mm above the water.
        ToleranceSettings angle = exact();
        angle.pathAngle = Degrees(1);
        const double beside = 0.5 / std::pow(std::sin(radians(steepness)), 2) * pi / 180;
        const DipTolerances found = tolerances(result, angle);
        QCOMPARE(found.contributions.size(), std::size_t(1));
        eachOfTheBottom(result, found,
                        [&](auto, double spread) { VERIFY_NEAR(spread, beside, 1e-3); });
    }

    // A slanted dip is at least 10° steep, so its angle deviates to one side only. From 0.5 mm
    // above the water.
    void jobTolerances_angleAtItsLimit_countsTheOtherSide() {
        const JobResult result = resultOf(slantedBox(10));
        ToleranceSettings angle = exact();
        angle.pathAngle = Degrees(1);
        const auto besideAt = [](double degrees) {
            return 0.5 / std::tan(radians(Degrees(degrees)));
        };
        const double beside = besideAt(10) - besideAt(11);
        eachOfTheBottom(result, tolerances(result, angle),
                        [&](auto, double spread) { VERIFY_NEAR(spread, beside, 5e-3); });
    }

    // The part begins 0.5 mm above the film, which floats past below it.
    void jobTolerances_flowingWater_movesColoursByItsWay() {
        Project flowing = box();
        DipPath& path = flowing.immersions.front().path;
        path.heading = Degrees(30);
        path.waterSpeed = MillimetresPerSecond(4);
        const JobResult result = resultOf(flowing);
        ToleranceSettings timing = exact();
        timing.timing = Seconds(0.2);
        const DipTolerances late = tolerances(result, timing);
        QCOMPARE(late.contributions.front().contributor, Contributor::Timing);
        eachOfTheBottom(result, late, [](auto, double spread) { VERIFY_NEAR(spread, 0.8, 5e-3); });
        ToleranceSettings speed = exact();
        speed.speed = 20 * percent;
        const double seconds = 0.5 / flowing.process.dipSpeed.value();
        const double way = 4 * seconds * (1 / 0.8 - 1 / 1.2) / 2;
        eachOfTheBottom(result, tolerances(result, speed),
                        [&](auto, double spread) { VERIFY_NEAR(spread, way, 2e-3); });
    }

    // The water carries the film 10 mm past below the part before they touch, so that the film's
    // centre, about which the film turns, then lies beside the part.
    void jobTolerances_filmTurnOnPath_turnsThePathAboutTheFilm() {
        Project flowing = box();
        const double way = 10;
        const double seconds = 0.5 / flowing.process.dipSpeed.value();
        flowing.immersions.front().path.waterSpeed = MillimetresPerSecond(way / seconds);
        ToleranceSettings settings = exact();
        settings.filmTurn = Degrees(1);
        const JobResult result = resultOf(flowing);
        eachOfTheBottom(result, tolerances(result, settings),
                        [&](const Eigen::Vector2d& at, double spread) {
                            const double arm = (at - Eigen::Vector2d(way, 0)).norm();
                            VERIFY_NEAR(spread, arm * pi / 180, 1e-2);
                        });
    }

    // The ball turns about its centre while it goes down. If it is tilted further by an angle δ
    // when it touches the film, the film there moves by the arc radius·δ. It touches 0.5 mm below
    // the beginning of its way of 52.5 mm; the tilt falls evenly on this way.
    void jobTolerances_tiltedEntry_movesColoursByTheArc() {
        Project tilted = ball();
        DipPath& path = tilted.immersions.front().path;
        path.kind = PathKind::Tilt;
        path.angle = Degrees(20);
        const JobResult result = resultOf(tilted);
        const double left = 52 / 52.5;
        const double tilt = left * radians(path.angle);
        const Eigen::Vector3d first = radius * Eigen::Vector3d(std::sin(tilt), -std::cos(tilt), 0);
        const auto nearFirst = [&](const ToleranceSettings& settings) {
            const DipTolerances found = tolerances(result, settings);
            const std::vector<SurfacePoint> places = tolerancePlaces(*tilted.model);
            std::vector<float> spreads;
            for (std::size_t place = 0; place < places.size(); ++place) {
                const Eigen::Vector3f at = position(tilted.model->mesh, places[place]);
                if ((at.cast<double>() - first).norm() < 5) {
                    spreads.push_back(found.places[place]);
                }
            }
            return spreadOf(spreads).median;
        };
        ToleranceSettings angle = exact();
        angle.pathAngle = Degrees(1);
        const double arc = left * radius * pi / 180;
        VERIFY_NEAR(nearFirst(angle), arc, 0.05 * arc);
        // In higher water the ball touches the film earlier.
        ToleranceSettings level = exact();
        level.waterLevel = Millimetres(2);
        const double earlier = radius * radians(path.angle) * 2 / 52.5;
        VERIFY_NEAR(nearFirst(level), earlier, 0.05 * earlier);
    }

    // The box waits for half a second below the water, then sinks on.
    void jobTolerances_pathWithWaits_hasTheEffectsOfAStraightDip() {
        Project waiting = box();
        DipPath& path = waiting.immersions.front().path;
        path.kind = PathKind::Poses;
        path.keys = {key(0, 0, 0), key(1, 0.6, 0), key(1.5, 0.6, 0), key(2, std::nullopt, 0)};
        const JobResult result = resultOf(waiting);
        ToleranceSettings settings = exact();
        settings.position = {Millimetres(0.6), Millimetres(0.8)};
        const DipTolerances found = tolerances(result, settings);
        QCOMPARE(found.contributions.size(), std::size_t(2));
        eachOfTheBottom(result, found, [](auto, double spread) { VERIFY_NEAR(spread, 1.0, 5e-3); });
    }

    // Film that grows by 1 % in a second, for a second longer, is 1 % longer.
    void jobTolerances_timingOfGrowingFilm_hasTheEffectOfSwell() {
        Project growing = box();
        growing.film.growthRate = percent;
        growing.film.growthLimit = 1;
        const JobResult result = resultOf(growing);
        ToleranceSettings settings = exact();
        settings.timing = Seconds(0.5);
        eachOfTheBottom(result, tolerances(result, settings),
                        [](const Eigen::Vector2d& at, double spread) {
                            VERIFY_NEAR(spread, 0.5 * percent * at.norm(), 2e-3);
                        });
    }

    // Film that has grown as far as it can before it meets the part is as long early as late.
    void jobTolerances_timingOfFilmThatHasGrown_movesNothing() {
        Project grown = box();
        grown.film.growthRate = 1;
        grown.film.growthLimit = 0.001;
        const JobResult result = resultOf(grown);
        ToleranceSettings settings = exact();
        settings.timing = Seconds(0.5);
        eachOfTheBottom(result, tolerances(result, settings),
                        [](auto, double spread) { VERIFY_NEAR(spread, 0.0, 2e-3); });
    }

    void jobTolerances_contributions_addUpToOne() {
        const DipTolerances& found = everythingOff();
        QCOMPARE(found.contributions.size(), contributorCount - 2); // no path, no timing
        double sum = 0;
        for (const Contribution& contribution : found.contributions) {
            sum += contribution.share;
        }
        VERIFY_NEAR(sum, 1.0, 1e-9);
        QVERIFY(found.worst.size() > 1);
        QVERIFY(found.worst[0].spread >= found.worst[1].spread);
        QCOMPARE(found.worst[0].spread, found.spread.maximum);
    }

    void jobTolerances_sampledDips_agreeWithTheLinearSpread() {
        const DipTolerances& found = everythingOff();
        QVERIFY(found.sampled);
        QCOMPARE(found.sampled->dips, 24);
        QVERIFY2(
            found.sampled->agrees(),
            qPrintable(
                QStringLiteral(
                    "95 % of the sampled spreads are within %1 mm, of the linear ones within %2 mm")
                    .arg(found.sampled->percentile95)
                    .arg(found.sampled->linear)));
    }

    void jobTolerances_anyNumberOfThreads_giveTheSameBits() {
        Project coarse = jobOf(sphereMesh(radius, 30, 60), 120, 25);
        coarse.tolerance.samples = 4;
        coarse.tolerance.filmPosition = coarse.tolerance.position;
        const auto run = [&](int threads) {
            const ThreadLimit limit(threads);
            return tolerances(resultOf(coarse), coarse.tolerance);
        };
        const DipTolerances one = run(1), three = run(3);
        QCOMPARE(one.places, three.places);
        QCOMPARE(one.filmPoints, three.filmPoints);
        QCOMPARE(one.sampled->percentile95, three.sampled->percentile95);
    }

    void tolerances_changed_leaveTheSheet() {
        Project strict = box();
        strict.tolerance.position[0] = Millimetres(2);
        strict.tolerance.marks.emplace_back();
        QCOMPARE(resultOf(strict).immersions[0].sheet.job.hash, box_.immersions[0].sheet.job.hash);
    }

    void report_tolerancesAskedFor_containsThem() {
        QVERIFY(!report(box_.project, box_).contains(QStringLiteral("zones")));
        JobResult asked = box_;
        ToleranceSettings settings = exact();
        settings.position[0] = Millimetres(0.6);
        settings.samples = 2;
        asked.tolerances =
            std::make_shared<const JobTolerances>(jobTolerances(box_, settings, registry(), {}));
        const QJsonObject json = report(asked.project, asked);
        const QJsonObject dip = json["immersions"].toArray()[0].toObject()["tolerances"].toObject();
        const QJsonObject contribution = dip["contributions"].toArray()[0].toObject();
        QCOMPARE(contribution["contributor"].toString(), QStringLiteral("position_x"));
        QCOMPARE(contribution["tolerance"].toDouble(), 0.6);
        QCOMPARE(contribution["share"].toDouble(), 1.0);
        QCOMPARE(dip["sampled"].toObject()["dips"].toInt(), 2);
        const QJsonObject zone = json["zones"].toArray()[0].toObject();
        QCOMPARE(zone["zone"].toString(), QStringLiteral("C"));
        QVERIFY(zone["holds"].toBool());
    }

private:
    // Returns the ball's tolerances with the settings of a new project.
    const DipTolerances& everythingOff() {
        if (!everythingOff_) {
            everythingOff_ = tolerances(ball_, ToleranceSettings());
        }
        return *everythingOff_;
    }

    JobResult box_, ball_;
    std::optional<DipTolerances> everythingOff_;
};

QTEST_MAIN(TolerancesTest)
#include "TolerancesTest.moc"

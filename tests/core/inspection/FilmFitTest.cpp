// Tests fitFilm() with simulated photos of a part that was dipped with other values than the
// project's.
#include "PhotographedPart.h"
#include "RememberedDips.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "base/Error.h"
#include "dip/Dip.h"
#include "inspection/JointFit.h"
#include "inspection/SimulatedPlaces.h"
#include "solver/SolverRegistry.h"

#include <QStandardPaths>
#include <QtTest>
#include <cmath>
#include <numeric>
#include <random>

using namespace dipwright;

namespace {

const test::Hidden hidden{1.062, 1.045, 4, 1.3, -0.9, 1.6};

const SolverRegistry& registry() {
    static const SolverRegistry plugins{QStringList{pluginFolder()}};
    return plugins;
}

const solver::SolverModule& solverModule() {
    static const test::RememberedDips module(registry().module(QStringLiteral("pbd-cpu")));
    return module;
}

const std::vector<test::PhotoCamera>& cameras() {
    static const auto two = test::camerasAround({{20, -35}, {140, -30}}, 280, 3.4, 4000);
    return two;
}

const FittedQuantity& found(const FilmFit& fit, FitQuantity quantity) {
    for (const FittedQuantity& one : fit.quantities) {
        if (one.unknown.quantity == quantity) {
            return one;
        }
    }
    throw Error(fitQuantityKey(quantity) + QStringLiteral(" was not fitted"), {});
}

void tell(const FilmFit& fit) {
    for (const FittedQuantity& one : fit.quantities) {
        qInfo("%s: %.5f -> %.5f (%.5f to %.5f)", qPrintable(fitQuantityKey(one.unknown.quantity)),
              one.before, one.after, one.low, one.high);
    }
    qInfo("%.3f px, %.3f mm -> %.3f px, %.3f mm; %d rounds, %d dips", fit.beforePixels,
          fit.beforeMillimetres, fit.afterPixels, fit.afterMillimetres, fit.rounds, fit.dips);
    for (const FitUnknown& one : fit.left) {
        qInfo("left: %s", qPrintable(fitQuantityKey(one.quantity)));
    }
}

FitRequest wanted() {
    return {{FitQuantity::ShiftX, FitQuantity::ShiftZ, FitQuantity::Turn, FitQuantity::SwellX,
             FitQuantity::SwellY, FitQuantity::Relaxation},
            false,
            {}};
}

// Returns an egg that enters the water tilted by 25° and is levelled on its way down.
Project tiltedEgg() {
    Project egg = test::eggToFit(1.3, 4);
    egg.film.relaxationTime = Seconds(hidden.relaxation);
    egg.process.depth = Millimetres(40);
    DipPath& path = egg.immersions.front().path;
    path.kind = PathKind::Tilt;
    path.angle = Degrees(25);
    path.heading = Degrees(30);
    return egg;
}

#define VERIFY_NEAR(value, wanted, allowed)                                                        \
    QVERIFY2(std::abs((value) - (wanted)) <= (allowed),                                            \
             qPrintable(QStringLiteral("%1, expected %2").arg(value).arg(wanted)))

} // namespace

class FilmFitTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        part_ = std::make_unique<test::PhotographedPart>(test::eggToFit(1.3, 2.5), hidden, 1.9,
                                                         solverModule());
    }

    // With perfect pairs, the only error comes from the tank's film, which has other film points.
    void fitFilm_perfectPairs_findsTheHiddenValues() {
        const FilmFit fitted = fit(part_->pairs(cameras(), 16, 12, 0.0, 1), wanted());
        tell(fitted);
        VERIFY_NEAR(found(fitted, FitQuantity::SwellX).after, hidden.swellX, 0.001);
        VERIFY_NEAR(found(fitted, FitQuantity::SwellY).after, hidden.swellY, 0.001);
        VERIFY_NEAR(found(fitted, FitQuantity::Relaxation).after / hidden.relaxation, 1, 0.05);
        VERIFY_NEAR(found(fitted, FitQuantity::ShiftX).after, hidden.shiftX, 0.05);
        VERIFY_NEAR(found(fitted, FitQuantity::ShiftZ).after, hidden.shiftZ, 0.05);
        VERIFY_NEAR(found(fitted, FitQuantity::Turn).after, hidden.turn, 0.1);
        QVERIFY(fitted.beforeMillimetres > 0.5);
        QVERIFY(fitted.afterMillimetres < 0.03);
        QCOMPARE(fitted.film.swellX, found(fitted, FitQuantity::SwellX).after);
        VERIFY_NEAR(fitted.immersions.front().rotation[1].value(), hidden.turn, 0.1);
    }

    void fitFilm_tiltedEntry_findsTheHiddenValues() {
        const double swell = tiltedEgg().film.swellX;
        const test::Hidden values{swell, swell, hidden.relaxation, hidden.shiftX, hidden.shiftZ,
                                  0,     2};
        const solver::SolverModule& solver = registry().module(QStringLiteral("pbd-cpu"));
        const test::PhotographedPart part(tiltedEgg(), values, 4, solver);
        const FitRequest request{
            {FitQuantity::ShiftX, FitQuantity::ShiftZ, FitQuantity::Depth}, false, {}};
        const FilmFit fitted = fitFilm(part.project(), part.field(),
                                       part.pairs(cameras(), 24, 12, 0.0, 1), request, solver, {});
        tell(fitted);
        VERIFY_NEAR(found(fitted, FitQuantity::ShiftX).after, hidden.shiftX, 0.03);
        VERIFY_NEAR(found(fitted, FitQuantity::ShiftZ).after, hidden.shiftZ, 0.03);
        VERIFY_NEAR(found(fitted, FitQuantity::Depth).after, 42.0, 0.3);
        QVERIFY(fitted.afterMillimetres < 0.1 * fitted.beforeMillimetres);
        QVERIFY(fitted.immersions.front().path == part.project().immersions.front().path);
        VERIFY_NEAR(fitted.depth->value(), 42.0, 0.3);
    }

    // A fit is worth something only if the job then repeats the fitted dip. On a path, turning the
    // part or dipping it deeper changes its motion.
    void fittedDips_changedDip_isTheDipOfTheFittedProject_data() {
        QTest::addColumn<bool>("isTilted");
        QTest::addColumn<float>("away"); // mm from the origin; solvers use other coordinates there
        QTest::newRow("straight") << false << 0.f;
        QTest::newRow("tilted") << true << 0.f;
        QTest::newRow("straight, far from the origin") << false << 10'000.f;
        QTest::newRow("tilted, far from the origin") << true << 10'000.f;
    }

    void fittedDips_changedDip_isTheDipOfTheFittedProject() {
        QFETCH(bool, isTilted);
        QFETCH(float, away);
        Project egg = tiltedEgg();
        if (!isTilted) {
            egg.immersions.front().path = {};
        }
        auto moved = std::make_shared<TexturedMesh>(*egg.model);
        for (Eigen::Vector3f& position : moved->mesh.positions) {
            position += Eigen::Vector3f(away, 0, -away);
        }
        egg.model = moved;
        const TriangleMesh& mesh = egg.model->mesh;
        const auto field = cachedDistanceField(mesh, 32, {});
        const auto setupOf = [&](const Project& project) {
            const Immersion& immersion = project.immersions.front();
            const PosedBody body = posedBody(mesh, immersion, project.process, 24);
            const FilledField filled(body, *field);
            return dipSetup(body, filled, immersion, project.film, project.process);
        };
        const FittedDips dips(egg, {setupOf(egg)});
        const ChangedDip changed = dips.dip(
            0, {{FitQuantity::ShiftX}, {FitQuantity::Turn}, {FitQuantity::Depth}}, {1.5, 4, -3});
        Project fitted = egg;
        fitted.immersions.front() = changed.immersion;
        fitted.process.depth = Millimetres(37);
        const solver::DipSetup wanted = setupOf(fitted);
        QCOMPARE(changed.immersion.offset[0].value(), 1.5);
        QVERIFY(std::abs(changed.immersion.rotation[1].value() - 4) < 1e-9);
        QVERIFY(std::abs(changed.setup.motion.travel - wanted.motion.travel) < 1e-6);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            QVERIFY(std::abs(changed.setup.motion.start[axis] - wanted.motion.start[axis]) < 1e-6);
            QVERIFY(std::abs(changed.setup.path.pivot[axis] - wanted.path.pivot[axis]) < 1e-6);
        }
        QCOMPARE(changed.setup.path.poses.size(), wanted.path.poses.size());
        for (std::size_t pose = 0; pose < wanted.path.poses.size(); ++pose) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                QVERIFY(std::abs(changed.setup.path.poses[pose].pivot[axis] -
                                 wanted.path.poses[pose].pivot[axis]) < 1e-6);
            }
        }
        QCOMPARE(dips.before({FitQuantity::Depth}), 40.0);
    }

    // Another solver, in double precision with a residual of 1e-9, stands for the tank.
    void fitFilm_16CornersWith1pxNoise_findsTheHiddenValues() {
        const test::PhotographedPart part(test::eggToFit(1.3, 2.5), hidden, 2.2, solverModule(),
                                          test::referenceTank());
        const FilmFit fitted =
            fitFilm(part.project(), part.field(), part.pairs(cameras(), 8, 12, 1.0, 1), {},
                    solverModule(), {});
        tell(fitted);
        VERIFY_NEAR(found(fitted, FitQuantity::SwellX).after / hidden.swellX, 1, 0.003);
        VERIFY_NEAR(found(fitted, FitQuantity::SwellY).after / hidden.swellY, 1, 0.003);
        VERIFY_NEAR(found(fitted, FitQuantity::Relaxation).after / hidden.relaxation, 1, 0.1);
        VERIFY_NEAR(found(fitted, FitQuantity::ShiftX).after, hidden.shiftX, 0.2);
        VERIFY_NEAR(found(fitted, FitQuantity::ShiftZ).after, hidden.shiftZ, 0.2);
        VERIFY_NEAR(found(fitted, FitQuantity::Turn).after, hidden.turn, 0.2);
        QVERIFY(found(fitted, FitQuantity::Relaxation).low < hidden.relaxation);
        QVERIFY(found(fitted, FitQuantity::Relaxation).high > hidden.relaxation);
        qInfo("%s", qPrintable(fitted.doubt));
        QVERIFY(fitted.doubt.contains(QStringLiteral("a change by 10 % moves none")));
    }

    void fitFilm_allVisibleCorners_findRelaxationWithin10Percent() {
        const FilmFit fitted = fit(part_->pairs(cameras(), 100, 12, 1.0, 1));
        tell(fitted);
        const FittedQuantity& relaxation = found(fitted, FitQuantity::Relaxation);
        QVERIFY(relaxation.high / relaxation.low < 1.1 * 1.1);
        QVERIFY(relaxation.low < hidden.relaxation && relaxation.high > hidden.relaxation);
        QCOMPARE(fitted.doubt, QString());
    }

    // Fits film and camera to many photos of one part. The part has the fit's own film, so that
    // noise is the only error. The dips near this film are simulated only once.
    void fitFilm_95PercentIntervals_holdTheTruthIn95Percent() {
        const int photos = test::sampleOf(50, 200);
        const FitPairs perfect = part_->pairs(cameras(), 8, 12, 0, 1);
        SimulatedPlaces places(part_->project(), part_->field(), perfect.printed, solverModule(),
                               perfect.where, {});
        std::vector<FitUnknown> unknowns;
        for (const FitQuantity quantity : usualQuantities()) {
            unknowns.push_back({quantity, 0});
        }
        Eigen::VectorXd centre(6);
        centre << 1.3, -0.9, 1.6, 3.1, 1.5, -1.2;
        const std::vector<bool> free(unknowns.size(), true);
        const PlacesNear near = places.near(unknowns, centre, free, {});
        std::mt19937 random{7};
        std::normal_distribution<double> off(0, 1);
        std::array<int, 6> held{};
        for (int photo = 0; photo < photos; ++photo) {
            FitPairs noisy = perfect;
            for (std::size_t i = 0; i < noisy.printed.size(); ++i) {
                if (near.places[i]) {
                    noisy.printed[i].pixel =
                        cameras()[std::size_t(noisy.printed[i].photo)].seen(*near.places[i]);
                    noisy.printed[i].pixel += Eigen::Vector2d(off(random), off(random));
                }
            }
            for (PlacePair& pair : noisy.body) {
                pair.pixel += Eigen::Vector2d(off(random), off(random));
            }
            const PartView start =
                fitPartCamera(noisy.body, noisy.photos, noisy.picture, noisy.where);
            const JointSolution solution =
                fitJointly(near, {noisy.printed, noisy.body, noisy.picture}, start, free,
                           CameraFit::Whole, noisy.where);
            for (std::size_t i = 0; i < held.size(); ++i) {
                const auto at = Eigen::Index(i);
                held[i] += std::abs(solution.unknowns[at] - centre[at]) <= solution.off[at];
            }
        }
        for (std::size_t i = 0; i < held.size(); ++i) {
            qInfo("%s: the interval holds the true value in %.1f %%",
                  qPrintable(fitQuantityKey(unknowns[i].quantity)), 100.0 * held[i] / photos);
        }
        const double share = std::accumulate(held.begin(), held.end(), 0) / (6.0 * photos);
        qInfo("all quantities together: in %.1f %%", 100 * share);
        QVERIFY(share > 0.93 && share < 0.97);
    }

    void fitFilm_ambiguousPairs_areRefused() {
        const FitPairs good = part_->pairs({cameras().front()}, 16, 12, 0.5, 1);
        // A ball looks the same from all sides. The print alone therefore cannot distinguish a turn
        // of the film from a movement of the camera.
        FitPairs printAlone = good;
        printAlone.body.clear();
        QVERIFY(errorOf(printAlone, {FitQuantity::Turn}).contains(QStringLiteral("camera")));
        QVERIFY(errorOf(good, {FitQuantity::Depth}).contains(QStringLiteral("moves none")));
        QVERIFY(errorOf(good, {FitQuantity::Growth}).contains(QStringLiteral("does not grow")));
        // Near the lowest point the film is hardly stretched.
        FitPairs low = good;
        std::erase_if(low.printed,
                      [](const PrintedPlace& place) { return place.sheet.norm() > 21; });
        QVERIFY(low.printed.size() >= 4);
        qInfo() << errorOf(low, wanted().quantities);
        QVERIFY(errorOf(low, wanted().quantities).contains(QStringLiteral("Relaxation")));
        FitPairs few = good;
        few.printed.resize(1);
        few.body.resize(6);
        QVERIFY(!errorOf(few, wanted().quantities).isEmpty());
        FitPairs stranger = good;
        for (PrintedPlace& place : stranger.printed) {
            place.sheet = {500, 500};
        }
        QVERIFY(errorOf(stranger, {}).contains(QStringLiteral("None of the printed places")));
        stranger.printed.front().dip = 1;
        QVERIFY(errorOf(stranger, {}).contains(QStringLiteral("dip 2")));
    }

    void fitFilm_cancelled_throws() {
        Progress progress;
        progress.cancelToken.cancel();
        const FitPairs pairs = part_->pairs({cameras().front()}, 16, 12, 0.5, 1);
        QVERIFY_EXCEPTION_THROWN(
            fitFilm(part_->project(), part_->field(), pairs, {}, solverModule(), progress),
            Cancelled);
    }

private:
    FilmFit fit(const FitPairs& pairs, const FitRequest& wish = {}) const {
        return fitFilm(part_->project(), part_->field(), pairs, wish, solverModule(), {});
    }

    QString errorOf(const FitPairs& pairs, const std::vector<FitQuantity>& quantities) const {
        try {
            fit(pairs, {quantities, false, {}});
        } catch (const Error& error) {
            return error.message();
        }
        return {};
    }

    std::unique_ptr<test::PhotographedPart> part_;
};

QTEST_MAIN(FilmFitTest)
#include "FilmFitTest.moc"

// Tests the pose search on bodies whose best poses are obvious.
#include "search/PoseSearch.h"
#include "HollowBodies.h"
#include "JoinedMeshes.h"
#include "SearchSubjects.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "base/Error.h"
#include "dip/Pose.h"
#include "parallel/Threads.h"
#include "search/Objective.h"
#include "solver/SolverRegistry.h"

#include <QStandardPaths>
#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

// Returns the body's direction that points down in this dip.
Eigen::Vector3d downOf(const Immersion& immersion) {
    return rotationMatrix(immersion.rotation).transpose() * -Eigen::Vector3d::UnitY();
}

// Returns the angle between the body's Y axis and the water, in degrees.
double tiltOf(const RankedPoses& ranked) {
    return std::asin(downOf(ranked.immersions[0]).y()) * 180 / pi;
}

// Returns settings for a search of only the six sides of the box, without refinement.
SearchSettings sidesOnly(int immersions) {
    SearchSettings settings;
    settings.immersions = immersions;
    settings.directions = settings.simulated = 6;
    settings.refined = settings.confirmed = 0;
    return settings;
}

// Returns a bowl whose sheet must not be printed if air stays under it; nothing else forbids it.
SearchSubject bowlThatMustVent() {
    SearchSubject subject = subjectOf(test::bowl());
    subject.verdict.air = 0.05;
    subject.verdict.damaged = subject.verdict.pale = 1;
    subject.verdict.edge = Millimetres(0);
    subject.film.columns = subject.film.rows = 37;
    subject.tolerance.limits.fill(Millimetres(100)); // the numerical error does not count
    return subject;
}

// Returns a cube with sides of 40 mm and a thin spike on top.
TriangleMesh cubeWithSpike() {
    const TriangleMesh cube = boxMesh({40, 40, 40});
    Eigen::Isometry3d onTop = Eigen::Isometry3d::Identity();
    onTop.rotate(Eigen::AngleAxisd(pi, Eigen::Vector3d::UnitX())); // the tip of a cone points down
    const TriangleMesh spike = transformed(coneMesh(0.045, 22, 24), onTop);
    const float rise = boundingBox(cube).max().y() - boundingBox(spike).min().y();
    return test::joined(cube, spike, {0, rise, 0});
}

void compare(const SearchResult& one, const SearchResult& other) {
    QCOMPARE(one.ranking.size(), other.ranking.size());
    for (std::size_t rank = 0; rank < one.ranking.size(); ++rank) {
        QCOMPARE(one.ranking[rank].objective, other.ranking[rank].objective);
        QVERIFY(one.ranking[rank].measures == other.ranking[rank].measures);
        QVERIFY(one.ranking[rank].immersions == other.ranking[rank].immersions);
    }
}

} // namespace

class PoseSearchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
        board_ = subjectOf(boxMesh({6, 40, 40})); // its broad faces towards ±X
    }

    void searchPoses_board_goesInEdgeFirst() {
        const auto ranking = search(board_, sidesOnly(1)).ranking;
        QVERIFY(!ranking.empty());
        QCOMPARE(ranking[0].immersions.size(), 1U);
        // If the board goes in edge first, film rolls onto both broad faces.
        QVERIFY(std::abs(downOf(ranking[0].immersions[0]).x()) < 0.02);
        QVERIFY(ranking[0].measures[Measure::Coverage] > 0.6);
    }

    void searchPoses_bowl_avoidsTheRimDown() {
        const SearchResult found = search(subjectOf(test::bowl()), sidesOnly(1));
        const RankedPoses& best = found.ranking.front();
        QVERIFY(best.measures[Measure::TrappedAir] < 0.02);
        // With the rim down, trapped air keeps much of the bowl bare.
        const auto rimDown =
            std::find_if(found.ranking.begin(), found.ranking.end(), [](const RankedPoses& each) {
                return downOf(each.immersions[0]).y() < -0.98;
            });
        QVERIFY(rimDown != found.ranking.end());
        QVERIFY(rimDown->measures[Measure::TrappedAir] > 0.4);
        QVERIFY(rimDown->measures[Measure::Coverage] < best.measures[Measure::Coverage]);
    }

    void searchPoses_twoDips_paintBothBroadFaces() {
        const RankedPoses best = search(board_, sidesOnly(2)).ranking.front();
        QCOMPARE(best.immersions.size(), 2U);
        const Eigen::Vector3d first = downOf(best.immersions[0]);
        const Eigen::Vector3d second = downOf(best.immersions[1]);
        QVERIFY2(first.dot(second) < -0.98, "the dips are not from opposite sides");
        QVERIFY(std::abs(first.x()) > 0.99);
        QVERIFY(best.measures[Measure::Coverage] > 0.8);
        QVERIFY(best.measures[Measure::Join] > 0);
        QVERIFY(best.immersions[0].name != best.immersions[1].name);
    }

    // A dip that paints only the spike makes a pair without a seam.
    void searchPoses_pairWithIdleDip_standsBelowOtherPairs() {
        SearchSubject subject = subjectOf(cubeWithSpike());
        subject.process.depth = Millimetres(20);
        SearchSettings settings = sidesOnly(2);
        setWeight(settings.aims, QStringLiteral("join"), 100);
        const SearchResult result = search(subject, settings);
        for (const Immersion& dip : result.ranking.front().immersions) {
            QVERIFY2(downOf(dip).y() < 0.9, "the best pair has a dip that paints only the spike");
        }
    }

    // The project's pose can be better than all that are found, or similar to a worse one.
    void searchPoses_projectsPoses_competeWithFoundOnes() {
        SearchSettings settings = sidesOnly(1);
        settings.finer = 1;
        SearchSubject subject = subjectOf(tetrahedronMesh(50));
        subject.immersions.resize(1);
        for (int turn = 0; turn < 8; ++turn) {
            subject.immersions[0].rotation[1] = Degrees(15 * turn);
            const SearchResult result = search(subject, settings);
            QVERIFY(result.ranking.front().objective >= result.current->objective);
        }
    }

    // An egg on its side is dipped from below and from above. Film reaches a little past the egg's
    // widest line.
    void searchPoses_largeRegistrationError_makesTheOverlapNarrow() {
        const auto narrow = [&](double error) {
            SearchSubject subject = subjectOf(ellipsoidMesh({14, 22, 10}, 40, 60));
            subject.registrationError = Millimetres(error);
            subject.immersions.resize(2);
            subject.immersions[1].rotation[0] = Degrees(180);
            return search(subject, sidesOnly(2)).current->measures[Measure::Narrow];
        };
        const double ofGoodDips = narrow(0.05), ofBadDips = narrow(10);
        QVERIFY2(ofGoodDips < 0.1,
                 qPrintable(
                     QStringLiteral("share of narrow overlap %1, expected < 0.1").arg(ofGoodDips)));
        QVERIFY2(ofBadDips > 0.9,
                 qPrintable(
                     QStringLiteral("share of narrow overlap %1, expected > 0.9").arg(ofBadDips)));
    }

    void searchPoses_ranking_fallsAndIsTheSameForAnyNumberOfThreads() {
        SearchSettings settings;
        settings.directions = 300;
        settings.simulated = 8;
        settings.finer = 3;
        settings.refined = settings.confirmed = 1;
        const SearchResult once = search(board_, settings);
        for (std::size_t rank = 1; rank < once.ranking.size(); ++rank) {
            const RankedPoses &better = once.ranking[rank - 1], &worse = once.ranking[rank];
            QVERIFY(better.isConfirmed || !worse.isConfirmed);
            if (better.isConfirmed == worse.isConfirmed) {
                QVERIFY(better.adviceOnDips() < worse.adviceOnDips() ||
                        (better.adviceOnDips() == worse.adviceOnDips() &&
                         better.objective >= worse.objective));
            }
        }
        // Further poses are confirmed only while no sheet can be printed.
        const auto confirmed =
            std::count_if(once.ranking.begin(), once.ranking.end(),
                          [](const RankedPoses& poses) { return poses.isConfirmed; });
        QVERIFY(confirmed >= 1 && confirmed <= 3);
        QVERIFY(confirmed == 1 || once.ranking[1].adviceOnDips() != Advice::Print);
        QVERIFY(once.ranking[0].adviceOnDips() != Advice::NotJudged);
        QVERIFY(once.isComplete);
        if (test::isWholeRun()) {
            compare(search(board_, settings), once);
        }
        const ThreadLimit one(1);
        compare(search(board_, settings), once);
    }

    // The objective wants the least film, and so the bowl's rim down: then little is painted. But
    // trapped air forbids to print this sheet.
    void searchPoses_forbiddenSheet_standsBelowPrintableOnesAndSaysWhy() {
        const SearchSubject subject = bowlThatMustVent();
        SearchSettings settings = sidesOnly(1);
        settings.finer = settings.confirmed = 6;
        for (const Measure measure : allMeasures()) {
            settings.aims.weights[measure] = measure == Measure::FilmUsed ? 1 : 0;
        }
        const std::vector<RankedPoses> ranking = search(subject, settings).ranking;
        const auto forbidden =
            std::find_if(ranking.begin(), ranking.end(), [](const RankedPoses& each) {
                return each.adviceOnDips() == Advice::DoNotPrint;
            });
        QVERIFY(forbidden != ranking.begin() && forbidden != ranking.end());
        QVERIFY(forbidden->objective > ranking.front().objective);
        QVERIFY(std::all_of(forbidden, ranking.end(), [](const RankedPoses& each) {
            return !each.isConfirmed || each.adviceOnDips() == Advice::DoNotPrint;
        }));
        const VerdictReason& reason = forbidden->verdicts.front().reasons.front();
        QCOMPARE(reason.advice, Advice::DoNotPrint);
        QCOMPARE(reason.kind, VerdictReason::Kind::Air);
    }

    // Film that is held at its edges stretches over a ball. Ink makes up for it where the ball is
    // light grey, but not where it is black.
    void searchPoses_stretchThatInkCannotCover_isInTheVerdict() {
        const auto isPale = [&](int grey) {
            SearchSubject subject = subjectOf(sphereMesh(20, 40, 60));
            subject.film.edges = {true, true, true, true};
            auto model = std::make_shared<TexturedMesh>(*subject.model);
            model->materials[0].colour = QColor(grey, grey, grey);
            subject.model = model;
            SearchSettings settings = sidesOnly(1);
            settings.finer = settings.confirmed = 1;
            const RankedPoses best = search(subject, settings).ranking.front();
            const std::vector<VerdictReason>& reasons = best.verdicts.front().reasons;
            return std::any_of(reasons.begin(), reasons.end(), [](const VerdictReason& reason) {
                return reason.kind == VerdictReason::Kind::Pale && reason.advice > Advice::Print;
            });
        };
        QVERIFY(isPale(0));
        QVERIFY(!isPale(200));
    }

    // The ball passes through film that tears at a tenth of stretch, and stays bare. If the other
    // dip may paint that, it is no fault of one dip.
    void searchPoses_weakFilmInOneDip_isForbidden() {
        SearchSubject subject = subjectOf(sphereMesh(20, 40, 60));
        subject.process.tearStretch = 1.1;
        const auto isTornBare = [&](int dips) {
            SearchSettings settings = sidesOnly(dips);
            settings.finer = settings.confirmed = 1;
            const RankedPoses best = search(subject, settings).ranking.front();
            const std::vector<VerdictReason>& reasons = best.verdicts.front().reasons;
            return std::any_of(reasons.begin(), reasons.end(), [](const VerdictReason& reason) {
                return reason.kind == VerdictReason::Kind::TornBare &&
                       reason.advice == Advice::DoNotPrint;
            });
        };
        QVERIFY(isTornBare(1));
        QVERIFY(!isTornBare(2));
    }

    // The numerical error forbids every sheet, which no prediction tells.
    void searchPoses_forbiddenSheets_standBelowPosesThatAreNotConfirmed() {
        SearchSubject subject = subjectOf(ellipsoidMesh({14, 22, 10}, 40, 60));
        subject.tolerance.limits.fill(Millimetres(0.001));
        subject.verdict.damaged = subject.verdict.pale = 1;
        subject.verdict.edge = Millimetres(0);
        SearchSettings settings = sidesOnly(1);
        settings.directions = 200;
        settings.simulated = settings.finer = 8;
        settings.confirmed = 1;
        const std::vector<RankedPoses> ranking = search(subject, settings).ranking;
        const auto firstConfirmed =
            std::find_if(ranking.begin(), ranking.end(),
                         [](const RankedPoses& poses) { return poses.isConfirmed; });
        QCOMPARE(std::distance(firstConfirmed, ranking.end()), std::ptrdiff_t(3));
        QVERIFY(firstConfirmed != ranking.begin());
        QVERIFY(std::all_of(firstConfirmed, ranking.end(), [](const RankedPoses& poses) {
            return poses.adviceOnDips() == Advice::DoNotPrint;
        }));
    }

    void searchPoses_poseThatCannotPrint_isNotConfirmedBeforeOneThatCan_data() {
        QTest::addColumn<double>("torn"); // weight
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("objective a little better") << 100.0 << 0.0 << 0.04;
        QTest::newRow("objective much better") << 0.0 << 0.04 << 1.0;
    }
    // The bowl's rim down has the best objective. The air under it shows before any pose is
    // confirmed.
    void searchPoses_poseThatCannotPrint_isNotConfirmedBeforeOneThatCan() {
        QFETCH(double, torn);
        QFETCH(double, least);
        QFETCH(double, most);
        SearchSettings settings = sidesOnly(1);
        settings.finer = 6;
        settings.confirmed = 1;
        for (const Measure measure : allMeasures()) {
            settings.aims.weights[measure] = 0;
        }
        settings.aims.weights[Measure::FilmUsed] = 1;
        settings.aims.weights[Measure::Torn] = torn;
        SearchSubject subject = bowlThatMustVent();
        subject.film.columns = subject.film.rows = 73;
        const std::vector<RankedPoses> ranking = search(subject, settings).ranking;
        QCOMPARE(ranking.front().adviceOnDips(), Advice::Print);
        const auto confirmed =
            std::count_if(ranking.begin(), ranking.end(),
                          [](const RankedPoses& poses) { return poses.isConfirmed; });
        QCOMPARE(confirmed, 1);
        const auto best = std::max_element(ranking.begin(), ranking.end(),
                                           [](const RankedPoses& one, const RankedPoses& other) {
                                               return one.objective < other.objective;
                                           });
        QVERIFY(best != ranking.begin() && best->measures[Measure::TrappedAir] > 0.25);
        const double better = best->objective - ranking.front().objective;
        QVERIFY2(better > least && better < most,
                 qPrintable(QStringLiteral("objective better by %1, expected %2 … %3")
                                .arg(better)
                                .arg(least)
                                .arg(most)));
    }

    // Both films must give about the same objective, because one table ranks poses dipped with
    // either.
    void searchPoses_finerFilm_agreesWithTheJobsFilm_data() {
        QTest::addColumn<int>("body");
        QTest::newRow("egg") << 0;
        if (test::isWholeRun()) {
            QTest::newRow("ring") << 1;
        }
    }
    void searchPoses_finerFilm_agreesWithTheJobsFilm() {
        QFETCH(int, body);
        const std::array<TriangleMesh, 2> meshes{ellipsoidMesh({14, 22, 10}, 40, 60),
                                                 torusMesh(18, 6, 60, 24)};
        SearchSubject subject = subjectOf(meshes[std::size_t(body)]);
        subject.film.columns = subject.film.rows = 120; // 50 cells along the body
        SearchSettings settings = sidesOnly(1);
        settings.finer = 3;
        const SearchResult ranked = search(subject, settings);
        settings.confirmed = settings.finer;
        const SearchResult confirmed = search(subject, settings);
        QVERIFY(!ranked.ranking.empty());
        for (const RankedPoses& poses : ranked.ranking) {
            const auto same = std::find_if(
                confirmed.ranking.begin(), confirmed.ranking.end(),
                [&](const RankedPoses& other) { return other.immersions == poses.immersions; });
            QVERIFY(same != confirmed.ranking.end() && same->isConfirmed);
            QVERIFY2(
                std::abs(same->objective - poses.objective) < 0.015,
                qPrintable(
                    QStringLiteral(
                        "objective %1 by the finer film, %2 by the job's; expected within 0.015")
                        .arg(poses.objective)
                        .arg(same->objective)));
        }
    }

    void searchPoses_mergedParts_giveTheSameRanking() {
        SearchSettings settings;
        settings.immersions = 2;
        settings.directions = 300;
        settings.simulated = 8;
        settings.refined = 0;
        settings.finer = 3;
        settings.confirmed = 1;
        const auto part = [&](int number) {
            const SearchShard made = searchShard(board_, settings, module(), number, 3, {});
            return shardFromFile(shardFile(made), QStringLiteral("part"));
        };
        const SearchResult merged =
            searchPoses(board_, settings, module(), {part(3), part(1), part(2)}, {}, {});
        compare(merged, search(board_, settings));
    }

    void searchPoses_foreignParts_areRefused() {
        SearchSettings settings = sidesOnly(1);
        settings.finer = 1;
        const SearchShard one = searchShard(board_, settings, module(), 1, 2, {});
        QVERIFY_EXCEPTION_THROWN(searchPoses(board_, settings, module(), {one}, {}, {}), Error);
        QVERIFY_EXCEPTION_THROWN(searchPoses(board_, settings, module(), {one, one}, {}, {}),
                                 Error);
        const SearchShard two = searchShard(board_, settings, module(), 2, 2, {});
        settings.seed = 2;
        QVERIFY_EXCEPTION_THROWN(searchPoses(board_, settings, module(), {one, two}, {}, {}),
                                 Error);
        settings.seed = 1;
        searchPoses(board_, settings, module(), {one, two}, {}, {});
        SearchSubject elsewhere = board_; // as if made with another solver
        elsewhere.identity = "other";
        QVERIFY_EXCEPTION_THROWN(searchPoses(elsewhere, settings, module(), {one, two}, {}, {}),
                                 Error);
        const QByteArray file = shardFile(one);
        QVERIFY_EXCEPTION_THROWN(shardFromFile(file.left(file.size() / 2), "half"), Error);
        QVERIFY_EXCEPTION_THROWN(shardFromFile(file + "more", "more"), Error);
        QVERIFY_EXCEPTION_THROWN(shardFromFile("no part", "other"), Error);
    }

    void searchPoses_equalPoses_areDippedOnce() {
        SearchSettings settings = sidesOnly(1);
        settings.simulated = 40;
        settings.directions = 300;
        int wanted = 0;
        searchPoses(subjectOf(sphereMesh(15, 40, 60)), settings, module(), {},
                    [&](const SearchState& state) {
                        wanted = state.wanted;
                        return std::chrono::seconds(0);
                    },
                    {});
        QVERIFY2(
            wanted <= 6,
            qPrintable(
                QStringLiteral("%1 dips, expected 6 or fewer").arg(wanted))); // a ball has one pose
    }

    void searchPoses_turnedBodyOfRevolution_isRankedAlike() {
        SearchSettings settings;
        settings.directions = 600;
        settings.simulated = 8;
        settings.refined = 2;
        settings.finer = 2;
        settings.confirmed = 0;
        const TriangleMesh body = coneMesh(0.5, 40, 64);
        const auto fineSubjectOf = [](const TriangleMesh& mesh) {
            SearchSubject subject = subjectOf(mesh);
            // So fine that the direction of the cells does not matter.
            subject.film.columns = subject.film.rows = 90;
            return subject;
        };
        const RankedPoses straight = search(fineSubjectOf(body), settings).ranking.front();
        const std::vector<double> angles =
            test::isWholeRun() ? std::vector<double>{17, 140} : std::vector<double>{140};
        for (const double angle : angles) {
            Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
            turn.rotate(Eigen::AngleAxisd(radians(Degrees(angle)), Eigen::Vector3d::UnitY()));
            const RankedPoses turned =
                search(fineSubjectOf(transformed(body, turn)), settings).ranking.front();
            QVERIFY2(std::abs(turned.objective - straight.objective) < 0.005,
                     qPrintable(QStringLiteral("objectives %1 and %2")
                                    .arg(straight.objective)
                                    .arg(turned.objective)));
            // The best tilt is the same, except for the film's cells, which do not turn with the
            // body.
            QVERIFY(std::abs(tiltOf(turned) - tiltOf(straight)) < 12);
        }
    }

    // The important faces of a cube: one face, or three that meet.
    void searchPoses_markedFaces_pointDown_data() {
        QTest::addColumn<int>("faces");
        QTest::newRow("one face") << 1;
        QTest::newRow("three faces") << 3;
    }
    void searchPoses_markedFaces_pointDown() {
        QFETCH(int, faces);
        SearchSubject cube = subjectOf(boxMesh({30, 30, 30}));
        for (int axis = 0; axis < faces; ++axis) {
            ZoneMark mark;
            mark.extent = MarkExtent::Face;
            mark.place[std::size_t(axis)] = Millimetres(15);
            cube.tolerance.marks.push_back(mark);
        }
        SearchSettings settings;
        settings.directions = 300;
        settings.simulated = 16;
        settings.refined = 1;
        settings.finer = 4;
        settings.confirmed = 0;
        settings.aims.weights = {{1, 0, 0, 0, 0, 0, 0, 0, 0}};
        settings.aims.zoneWeights = {1, 0, 0};
        const RankedPoses best = search(cube, settings).ranking.front();
        const Eigen::Vector3d down = downOf(best.immersions[0]);
        QVERIFY2(
            best.measures[Measure::Quality] > 0.8,
            qPrintable(
                QStringLiteral("quality %1, expected > 0.8").arg(best.measures[Measure::Quality])));
        for (int axis = 0; axis < faces; ++axis) {
            // The face points down or sideways, never up.
            QVERIFY2(
                down[axis] > -0.05,
                qPrintable(QStringLiteral("the face's normal points down by %1, expected > -0.05")
                               .arg(down[axis])));
        }
    }

    void searchPoses_limits_comeBeforeTheObjective() {
        SearchSettings settings = sidesOnly(1);
        const SearchResult free = search(board_, settings);
        // The limit on stretch is the largest stretch of the last pose.
        const double painted = free.ranking.back().measures[Measure::Coverage];
        setLimit(settings.aims, QStringLiteral("stretch"),
                 free.ranking.back().measures[Measure::Stretch] + 1e-6);
        const SearchResult limited = search(board_, settings);
        QVERIFY(limited.ranking.front().limitsMissed == 0);
        for (std::size_t rank = 1; rank < limited.ranking.size(); ++rank) {
            QVERIFY(limited.ranking[rank].limitsMissed >= limited.ranking[rank - 1].limitsMissed);
        }
        QVERIFY(painted > 0);
    }

    void searchPoses_tankWithLimits_ranksPosesThatExceedThemLast_data() {
        QTest::addColumn<int>("immersions");
        QTest::addColumn<int>("confirmed");
        QTest::newRow("one dip") << 1 << 0;
        QTest::newRow("one dip, confirmed") << 1 << 1;
        QTest::newRow("two dips") << 2 << 0;
    }
    // On its edge, the board goes 42 mm deep. On a broad face it goes only 8 mm deep.
    void searchPoses_tankWithLimits_ranksPosesThatExceedThemLast() {
        QFETCH(int, immersions);
        QFETCH(int, confirmed);
        SearchSubject subject = board_;
        subject.tank.emplace();
        subject.tank->waterDepth = Millimetres(30);
        SearchSettings settings = sidesOnly(immersions);
        settings.confirmed = confirmed;
        const SearchResult found = search(subject, settings);
        const auto isFlat = [](const RankedPoses& poses) {
            return std::all_of(
                poses.immersions.begin(), poses.immersions.end(),
                [](const Immersion& immersion) { return std::abs(downOf(immersion).x()) > 0.99; });
        };
        bool areLast = false;
        for (const RankedPoses& poses : found.ranking) {
            QCOMPARE(poses.tankFaults.isEmpty(), isFlat(poses));
            QVERIFY(!areLast || !poses.tankFaults.isEmpty());
            areLast = !poses.tankFaults.isEmpty();
        }
        QVERIFY(isFlat(found.ranking.front()));
        QVERIFY(areLast);
        const QString told = found.ranking.back().tankFaults.front();
        QVERIFY2(told.contains(QStringLiteral("goes 42.0 mm under water")), qPrintable(told));
        QCOMPARE(told.startsWith(QStringLiteral("Dip ")), immersions == 2);
    }

    void searchPoses_cancelled_keepsTheBest() {
        Progress progress;
        progress.cancelToken.cancel();
        QVERIFY_EXCEPTION_THROWN(searchPoses(board_, sidesOnly(1), module(), {}, {}, progress),
                                 Cancelled);
        Progress later;
        SearchSettings settings;
        settings.directions = 300;
        const SearchResult kept = searchPoses(
            board_, settings, module(), {},
            [&](const SearchState& state) {
                if (!state.soFar.ranking.empty()) {
                    later.cancelToken.cancel();
                }
                return std::chrono::seconds(0);
            },
            later);
        QVERIFY(!kept.isComplete);
        QVERIFY(!kept.ranking.empty());
    }

    void searchPoses_directions_areListedWithTheirObjective() {
        SearchSettings settings = sidesOnly(1);
        settings.directions = 200;
        settings.finer = 1;
        const SearchResult result = search(board_, settings);
        QCOMPARE(result.directions.size(), 200U);
        const auto judged =
            std::count_if(result.directions.begin(), result.directions.end(),
                          [](const TriedDirection& tried) { return tried.objective.has_value(); });
        QVERIFY(judged >= 6);
    }

    void reasonText_namesWhatDiffers() {
        RankedPoses one, other;
        one.measures[Measure::Coverage] = 0.87;
        other.measures[Measure::Coverage] = 0.9;
        one.measures[Measure::Stretch] = 2.2;
        other.measures[Measure::Stretch] = 1.8;
        const auto found = differences(one, other, {}, 100);
        QCOMPARE(found.size(), 2U);
        QVERIFY(!found[0].isBetter && !found[1].isBetter);
        QCOMPARE(reasonText(found),
                 QStringLiteral("Coverage −3.0 % (worse), Largest stretch +0.40 (worse)"));
        QCOMPARE(reasonText(differences(one, one, {}, 100)), QStringLiteral("no difference"));
    }

    void poseAims_valuesOutOfRange_areRefused() {
        SearchSettings settings;
        QVERIFY_EXCEPTION_THROWN(setWeight(settings.aims, "coverage", -1), Error);
        const auto messageOf = [&](const QString& key, double weight) {
            try {
                setWeight(settings.aims, key, weight);
            } catch (const Error& error) {
                return error.message();
            }
            return QString();
        };
        QVERIFY(messageOf("colour", 1).contains("zone_a"));
        QVERIFY(messageOf("colour", 1).contains("coverage"));
        try {
            setLimit(settings.aims, "join", 1e7);
            QFAIL("the limit was accepted, expected an Error");
        } catch (const Error& error) {
            QCOMPARE(error.message(), QStringLiteral("Choose a number from 0 to 1000000"));
        }
        QVERIFY_EXCEPTION_THROWN(
            setLimit(settings.aims, "coverage", std::numeric_limits<double>::quiet_NaN()), Error);
        settings.aims.weights = {};
        QVERIFY_EXCEPTION_THROWN(requireValid(settings), Error);
        setWeight(settings.aims, "zone_b", 7);
        QCOMPARE(settings.aims.zoneWeights[1], 7.0);
    }

    void measureText_stretchPastTheScale_saysAtLeast() {
        QCOMPARE(measureText(Measure::Stretch, 1.844), QStringLiteral("1.84"));
        QCOMPARE(measureText(Measure::Stretch, 65535.0 / 4096), QStringLiteral("≥ 16"));
    }

    void printQuality_stretchedOrGatheredFilm_isLower() {
        QCOMPARE(printQuality(1, 1), 1.0);
        QCOMPARE(printQuality(1.2, 0.7), 1.0);
        QVERIFY(printQuality(1.5, 1) > printQuality(2, 1));
        QVERIFY(printQuality(1, 0.6) > printQuality(1, 0.4));
        QCOMPARE(printQuality(3, 1), 0.0);
        QCOMPARE(printQuality(1, 0.1), 0.0);
    }

    void searchPoses_trappedAirUnderMask_isNotJudged() {
        SearchSubject dome = subjectOf(test::bowl());
        dome.immersions.resize(1); // rim down
        SearchSettings settings = sidesOnly(1);
        settings.finer = settings.confirmed = 1;
        const auto tellsAir = [&] {
            const std::vector<Verdict> verdicts = search(dome, settings).current.value().verdicts;
            const auto& reasons = verdicts.at(0).reasons;
            return std::any_of(reasons.begin(), reasons.end(), [](const VerdictReason& reason) {
                return reason.kind == VerdictReason::Kind::Air;
            });
        };
        QVERIFY(tellsAir());
        MaskMark inside;
        inside.radius = Millimetres(50);
        inside.path = {{{Millimetres(0), Millimetres(29), Millimetres(0)}, {0, -1, 0}}};
        dome.mask = surfaceMask(dome.model, {inside});
        QVERIFY(!tellsAir());
    }

    void searchPoses_wholePartMasked_isRefused() {
        SearchSubject masked = board_;
        MaskMark all;
        all.extent = MarkExtent::Material;
        masked.mask = surfaceMask(masked.model, {all});
        QVERIFY_EXCEPTION_THROWN(search(masked, sidesOnly(2)), Error);
    }

private:
    const solver::SolverModule& module() { return registry_->module("auto"); }
    SearchResult search(const SearchSubject& subject, const SearchSettings& settings) {
        return searchPoses(subject, settings, module(), {}, {}, {});
    }

    std::unique_ptr<SolverRegistry> registry_;
    SearchSubject board_;
};

QTEST_GUILESS_MAIN(PoseSearchTest)
#include "PoseSearchTest.moc"

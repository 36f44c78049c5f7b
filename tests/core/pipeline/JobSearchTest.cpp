// Tests that a pose search judges poses as the job does, and that the job takes over its dips.
// Takes six seconds, because it runs two searches and a job with a refined film.
#include "pipeline/JobSearch.h"
#include "BallJob.h"
#include "TestFolders.h"

#include "pipeline/Pipeline.h"
#include "pipeline/SolverChoice.h"

#include <QGuiApplication>
#include <QStandardPaths>
#include <QtTest>

#include <algorithm>
#include <atomic>
#include <functional>

using namespace dipwright;

namespace {

// A ball whose first film is not exact enough for its narrow tolerance.
Project narrowJob() {
    Project project = test::ballJob();
    project.film.resolution = FilmResolution::Automatic;
    project.tolerance.limits.fill(Millimetres(0.2));
    project.process.depth = Millimetres(12);
    return project;
}

Project withColour(Project project, const QColor& colour) {
    TexturedMesh model = *project.model;
    model.textures.front().fill(colour);
    project.model = std::make_shared<const TexturedMesh>(std::move(model));
    return project;
}

SearchSettings shortSearch() {
    SearchSettings settings;
    settings.directions = 20;
    settings.simulated = 6;
    settings.refined = 0;
    settings.finer = settings.confirmed = 1;
    return settings;
}

} // namespace

class JobSearchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
        job_ = narrowJob();
        solver_ = chooseSolver(job_.process.solver, *registry_).solver;
        best_ = searchPoses(searchSubject(job_, solver_.id), shortSearch(),
                            registry_->module(solver_.id), {}, {}, {})
                    .ranking.front();
        found_ = job_;
        found_.immersions = best_.immersions;
        result_ = runJob(found_, *registry_, {}, nullptr, {});
    }

    // The search repeats the dip with smaller cells as the job does, and gives the same verdict.
    void bestPoses_haveTheFilmOfTheJob() {
        const ImmersionResult& dip = result_.immersions.front();
        QVERIFY(dip.refinement > 1);
        QCOMPARE(best_.films.front()->refinement, dip.refinement);
        QVERIFY(!best_.films.front()->next);
        const DippedFilm& searched = best_.films.front()->own->film();
        QVERIFY(searched.grid == dip.laid->film().grid);
        QVERIFY(searched.positions == dip.laid->film().positions);
        QCOMPARE(best_.verdicts.front().advice, dip.verdict.advice);
        QCOMPARE(best_.films.front()->error->offBy.percentile95,
                 dip.numericalError->offBy.percentile95);
    }

    void foundDips_areNotSimulatedAgain() {
        std::atomic<int> frames = 0;
        JobOptions options;
        options.observer = [&frames](std::size_t, const FilmFrame&) { ++frames; };
        const auto kept = foundDips(job_, best_, solver_);
        const JobResult result = runJob(found_, *registry_, options, kept.get(), {});
        QCOMPARE(frames.load(), 0);
        QVERIFY(result.immersions.front().laid == best_.films.front()->own);
        QVERIFY(result.immersions.front().sheet.image == result_.immersions.front().sheet.image);
    }

    void ownPoses_areMarked() {
        Project own = job_;
        own.immersions.front().rotation[0] = Degrees(12.5);
        SearchSettings settings = shortSearch();
        settings.confirmed = 0;
        const SearchResult result = searchPoses(searchSubject(own, solver_.id), settings,
                                                registry_->module(solver_.id), {}, {}, {});
        for (const RankedPoses& poses : result.ranking) {
            QCOMPARE(poses.areOwn, poses.immersions.front().rotation[0] == Degrees(12.5));
        }
        QVERIFY(std::any_of(result.ranking.begin(), result.ranking.end(),
                            [](const RankedPoses& poses) { return poses.areOwn; }));
    }

    void searchSubject_otherPictures_hasAnotherIdentity() {
        const QByteArray identity = searchSubject(job_, solver_.id).identity;
        QCOMPARE(searchSubject(withColour(job_, QColor(200, 80, 20)), solver_.id).identity,
                 identity);
        QVERIFY(searchSubject(withColour(job_, QColor(200, 80, 21)), solver_.id).identity !=
                identity);
        Project ranked = job_; // only the merge ranks the dips
        ranked.verdict.pale = 0.5;
        ranked.profiles.tank.emplace();
        ranked.immersions.front().rotation[0] = Degrees(12.5);
        QCOMPARE(searchSubject(ranked, solver_.id).identity, identity);
    }

    void haveSameSearchSubject_changedInput_isFalse() {
        const auto isSame = [this](const std::function<void(Project&)>& change) {
            Project changed = job_;
            change(changed);
            return haveSameSearchSubject(changed, job_);
        };
        QVERIFY(isSame([](Project& project) {
            project.name = QStringLiteral("other");
            project.immersions.front().rotation[0] = Degrees(12.5);
            project.sheet.bleed = Millimetres(5);
        }));
        QVERIFY(!isSame([](Project& project) { project.masks.emplace_back(); }));
        QVERIFY(!isSame([](Project& project) { project.sheet.white = WhiteLayer::First; }));
        QVERIFY(!isSame([](Project& project) { project.artwork.base = Qt::white; }));
        QVERIFY(!isSame([](Project& project) { project.profiles.tank.emplace(); }));
        QVERIFY(!isSame([](Project& project) { project = withColour(project, Qt::black); }));
    }

    void foundDips_posesThatAreNotConfirmed_areNone() {
        RankedPoses coarse = best_;
        coarse.films.clear();
        QVERIFY(!foundDips(job_, coarse, solver_));
    }

private:
    std::unique_ptr<SolverRegistry> registry_;
    Project job_, found_; // before and after the search
    JobResult result_;    // of found_
    SolverInfo solver_;
    RankedPoses best_;
};

QTEST_MAIN(JobSearchTest)
#include "JobSearchTest.moc"

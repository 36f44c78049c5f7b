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

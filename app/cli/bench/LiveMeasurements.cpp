#include "cli/bench/Measurements.h"

#include "pipeline/JobDraft.h"
#include "project/ProjectStore.h"
#include "project/Samples.h"

namespace dipwright::cli {
namespace {

constexpr double turnOfChange = 7;     // degrees
constexpr double turnWhileDragged = 1; // degrees from one draft to the next
constexpr double secondsOfDrag = 3;

// A project that is turned again and again, as by hand.
class TurnedJob {
public:
    TurnedJob(Project project, const BenchSolver& solver, const Progress& progress)
        : project_(std::move(project)), solver_(solver), progress_(progress) {
        project_.process.solver = solver.id;
        run(0);
        draft();
    }

    void turn(double degrees) {
        std::array<Degrees, 3>& rotation = project_.immersions.front().rotation;
        rotation[0] = Degrees(rotation[0].value() + degrees / 2);
        rotation[1] = Degrees(rotation[1].value() + degrees);
    }
    void draft() {
        coarsest_ = coarsestDraft(project_, results_);
        run(coarsest_);
    }
    // Runs all further drafts, then the job, but without refined films.
    void finish() {
        for (int level = coarsest_; level-- > 0;) {
            run(level);
        }
    }

private:
    void run(int level) {
        results_.add(level, std::make_shared<JobResult>(runLevel(project_, level, coarsest_,
                                                                 solver_.registry, results_,
                                                                 progress_.silent())));
    }

    Project project_;
    const BenchSolver& solver_;
    const Progress& progress_;
    JobDrafts results_;
    int coarsest_ = 0;
};

LiveRow measure(const QString& model, const BenchSolver& solver, TurnedJob& job) {
    LiveRow row;
    row.model = model;
    std::vector<double> first, last;
    for (int run = 0; run < solver.runs; ++run) {
        job.turn(turnOfChange);
        first.push_back(secondsOf([&] { job.draft(); }));
        last.push_back(first.back() + secondsOf([&] { job.finish(); }));
    }
    row.firstAnswer = statistics(std::move(first));
    row.final = statistics(std::move(last));
    int drafts = 0;
    double seconds = 0;
    for (; seconds < secondsOfDrag; ++drafts) {
        job.turn(turnWhileDragged);
        seconds += secondsOf([&] { job.draft(); });
    }
    row.dipsPerSecond = drafts / seconds;
    return row;
}

} // namespace

std::vector<LiveRow> measureLive(const BenchSolver& solver, QStringList projects,
                                 const Progress& progress) {
    if (projects.isEmpty()) {
        BenchBodies::turtleFile(); // throws if there are no samples
        projects = sampleProjects();
    }
    std::vector<LiveRow> rows;
    for (const QString& path : projects) {
        const Project project = loadProject(path);
        progress(double(rows.size()) / double(projects.size()), project.name);
        TurnedJob job(project, solver, progress);
        rows.push_back(measure(project.name, solver, job));
    }
    return rows;
}

} // namespace dipwright::cli

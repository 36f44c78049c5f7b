// What a run says of its sheets against the full check of the same sheets, a line an immersion:
// how a verdict's law and its constants are held against models.
//
//   certainty_bench [points=COLUMNSxROWS] [found] JOB.dipw …
//
// found: in the two poses that a pose search finds, in place of the job's own. Right is a verdict
// unless it has a sheet printed that moves by more than it says.

#include "base/Error.h"
#include "pipeline/Pipeline.h"
#include "pipeline/PoseSearch.h"
#include "pipeline/SheetCertainty.h"
#include "project/ProjectStore.h"

#include <QGuiApplication>

#include <cstdio>
#include <string_view>

using namespace dipwright;

namespace {

struct Options {
    QStringList jobs;
    int columns = 0, rows = 0; // 0: the job's own
    bool areFound = false;
};

Options parsed(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "found") {
            options.areFound = true;
        } else if (std::sscanf(argv[i], "points=%dx%d", &options.columns, &options.rows) != 2) {
            options.jobs.append(QString::fromLocal8Bit(argv[i]));
        }
    }
    return options;
}

Project jobOf(const QString& file, const Options& options, const SolverRegistry& registry) {
    Project job = loadProject(file);
    if (options.areFound) {
        PoseSearchOptions search;
        search.immersions = 2;
        const solver::SolverModule& module = registry.module(job.process.solver);
        job.immersions = searchPoses(job, module, search, {}).front().immersions;
    }
    if (options.columns > 0) {
        job.film.columns = options.columns;
        job.film.rows = options.rows;
    }
    return job;
}

bool isRight(const ImmersionResult& said, const ImmersionCertainty& check) {
    const double offBy = said.certainty->offBy.percentile95;
    return said.verdict.advice != Advice::Print ||
           (check.halfStep.distance.percentile95 <= offBy &&
            check.halfSpacing.distance.percentile95 <= offBy);
}

void print(const Project& job, const ImmersionResult& said, const ImmersionCertainty& check) {
    const CertaintyEstimate& estimate = *said.certainty;
    std::printf("%s/%s %dx%d: %s, off by %.3f | step %.3f, checked %.3f | spacing %.3f, checked "
                "%.3f | border %.3f, checked %.3f | %s\n",
                qPrintable(job.name), qPrintable(said.immersion.name), job.film.columns,
                job.film.rows, qPrintable(adviceKey(said.verdict.advice)),
                estimate.offBy.percentile95, estimate.halfStep().distance.percentile95,
                check.halfStep.distance.percentile95, estimate.halfSpacing().distance.percentile95,
                check.halfSpacing.distance.percentile95, estimate.halfSpacing().paintedOnce,
                check.halfSpacing.paintedOnce, isRight(said, check) ? "right" : "WRONG");
    std::fflush(stdout);
}

void judge(const QString& file, const Options& options, const SolverRegistry& registry) {
    const Project job = jobOf(file, options, registry);
    const JobResult said = runJob(job, registry, {}, nullptr, {});
    const std::vector<ImmersionCertainty> check = sheetCertainty(job, registry, {});
    for (std::size_t number = 0; number < check.size(); ++number) {
        print(job, said.immersions[number], check[number]);
    }
}

} // namespace

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    const Options options = parsed(argc, argv);
    const SolverRegistry registry;
    for (const QString& file : options.jobs) {
        try {
            judge(file, options, registry);
        } catch (const Error& error) {
            std::printf("%s: %s\n", qPrintable(file), qPrintable(error.sentence()));
        }
    }
    return 0;
}

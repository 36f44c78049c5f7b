// How long it takes to tell a job's tolerances, and what comes of it:
//   tolerance_bench [solver=ID] [samples=N] [contributors=8] JOB.dipw…
// A line an immersion: seconds on the clock and of all processors for the whole job's tolerances,
// the 95th percentile that the contributions come to, and that of the dips with all off at once
// against it. With `contributors=8`, the usual eight: the body's three turns and two places, the
// film's swell, the water level and, on the same dips as the body's, the film's turn.
#include "pipeline/JobTolerances.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"

#include <QGuiApplication>
#include <QTextStream>

#include <chrono>
#include <ctime>

using namespace dipwright;

namespace {

struct Options {
    QString solver;
    int samples = -1; // the project's
    bool onlyEight = false;
};

void measure(const QString& path, const Options& options, QTextStream& out) {
    Project project = loadProject(path);
    ToleranceSettings settings = project.tolerance;
    if (options.samples >= 0) {
        settings.samples = options.samples;
    }
    if (options.onlyEight) {
        settings.filmPosition = {Millimetres(0), Millimetres(0)};
        settings.speed = settings.relaxation = 0;
    }
    const SolverRegistry registry;
    JobOptions job;
    job.solver = options.solver;
    job.estimatesCertainty = false;
    const JobResult result = runJob(project, registry, job, nullptr, {});
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t clock = std::clock();
    const JobTolerances tolerances = jobTolerances(result, settings, registry, {});
    const double processors = double(std::clock() - clock) / CLOCKS_PER_SEC;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (std::size_t number = 0; number < tolerances.dips.size(); ++number) {
        const DipTolerances& dip = tolerances.dips[number];
        out << QStringLiteral("%1, %2: %3 s, %4 s of all processors for the job; %5 "
                              "contributors, 95 % within %6 mm")
                   .arg(project.name, result.immersions[number].immersion.name)
                   .arg(seconds, 0, 'f', 2)
                   .arg(processors, 0, 'f', 2)
                   .arg(dip.contributions.size())
                   .arg(dip.spread.percentile95, 0, 'f', 3);
        if (dip.sampled) {
            out << QStringLiteral("; %1 dips: %2 mm against %3 mm, %4 %")
                       .arg(dip.sampled->dips)
                       .arg(dip.sampled->percentile95, 0, 'f', 3)
                       .arg(dip.sampled->linear, 0, 'f', 3)
                       .arg(100 * (dip.sampled->percentile95 / dip.sampled->linear - 1), 0, 'f', 1);
        }
        out << '\n';
    }
    out.flush();
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    Options options;
    for (const QString& argument : QCoreApplication::arguments().mid(1)) {
        if (argument.startsWith(QLatin1String("solver="))) {
            options.solver = argument.mid(7);
        } else if (argument.startsWith(QLatin1String("samples="))) {
            options.samples = argument.mid(8).toInt();
        } else if (argument == QLatin1String("contributors=8")) {
            options.onlyEight = true;
        } else {
            measure(argument, options, out);
        }
    }
    return 0;
}

// Measures how long it takes to compute a job's tolerances, and prints the result:
//   tolerance_bench [solver=ID] [samples=N] [contributors=8] JOB.dipw…
// Prints one line per dip: wall seconds and processor seconds for the tolerances of the whole job;
// the 95th percentile computed from the sum of the contributions; the 95th percentile from dips
// with all errors at once. `contributors=8` uses the usual eight: the body's three rotations and
// two offsets, the film's swell, the water level, and the film's rotation (from the same dips as
// the body's rotation).
#include "Bench.h"
#include "pipeline/JobTolerances.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"

#include <QGuiApplication>
#include <QTextStream>

using namespace dipwright;

namespace {

void measure(const QString& path, const bench::Arguments& arguments, QTextStream& out) {
    Project project = loadProject(path);
    ToleranceSettings settings = project.tolerance;
    settings.samples = arguments.number("samples", settings.samples);
    if (arguments.number("contributors", 0) == 8) {
        settings.filmPosition = {Millimetres(0), Millimetres(0)};
        settings.speed = settings.relaxation = 0;
    }
    const SolverRegistry registry;
    JobOptions job;
    job.solver = QString::fromStdString(arguments.value("solver"));
    job.estimatesNumericalError = false;
    const JobResult result = runJob(project, registry, job, nullptr, {});
    JobTolerances tolerances;
    const bench::Elapsed time =
        bench::elapsed([&] { tolerances = jobTolerances(result, settings, registry, {}); });
    for (std::size_t number = 0; number < tolerances.dips.size(); ++number) {
        const DipTolerances& dip = tolerances.dips[number];
        out << QStringLiteral("%1, %2: %3 s, %4 s of all processors for the job; %5 "
                              "contributors, 95 % within %6 mm")
                   .arg(project.name, result.immersions[number].immersion.name)
                   .arg(time.seconds, 0, 'f', 2)
                   .arg(time.processors, 0, 'f', 2)
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
    const bench::Arguments arguments(argc, argv);
    for (const std::string& path : arguments.words()) {
        measure(QString::fromStdString(path), arguments, out);
    }
    return 0;
}

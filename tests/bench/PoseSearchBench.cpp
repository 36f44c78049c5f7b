// Measures how long a pose search takes and what it finds:
//   pose_search_bench [solver=ID] [immersions=1|2] [directions=N] [candidates=N] [refined=N]
//                     [finer=N] [confirmed=N] [weight.MEASURE=X] JOB.dipw…
// Prints one line per project: wall seconds and processor seconds, number of dips, the objective of
// the best poses and of the project's own, the accurate share of the best poses' painted area, the
// share of their overlap that is too narrow, coverage previews per second on one thread, and the
// best poses.
#include "Bench.h"
#include "model/TexturedMesh.h"
#include "pipeline/JobSearch.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "search/CoveragePreview.h"
#include "solver/SolverRegistry.h"

#include <QGuiApplication>
#include <QTextStream>

using namespace dipwright;

namespace {

void measure(const QString& path, const QString& solver, const SearchSettings& settings,
             const SolverRegistry& registry, QTextStream& out) {
    const Project project = loadProject(path);
    int dips = 0;
    SearchResult result;
    const bench::Elapsed time = bench::elapsed([&] {
        result = searchPoses(searchSubject(project, solver), settings, registry.module(solver), {},
                             [&](const SearchState& state) {
                                 dips = state.done;
                                 return std::chrono::seconds(0);
                             },
                             {});
    });
    const CoveragePreview preview(project.model->mesh);
    constexpr int previews = 50;
    const double previewing = bench::secondsOf([&] {
        for (int turn = 0; turn < previews; ++turn) {
            Immersion immersion;
            immersion.rotation = {Degrees(7 * turn), Degrees(0), Degrees(3 * turn)};
            preview.ofModel(preview.at(immersion, project.film, project.process));
        }
    });
    const RankedPoses& best = result.ranking.front();
    out << QStringLiteral("%1, %2 dips to plan: %3 s, %4 s of all processors, %5 dips; objective "
                          "%6, the project's %7; certain %8 %, narrow overlap %9 %, coverage %10 "
                          "%, quality %11 %; %12 previews a second;")
               .arg(project.name)
               .arg(settings.immersions)
               .arg(time.seconds, 0, 'f', 2)
               .arg(time.processors, 0, 'f', 1)
               .arg(dips)
               .arg(best.objective, 0, 'f', 4)
               .arg(result.current ? result.current->objective : 0, 0, 'f', 4)
               .arg(100 * best.measures[Measure::Certain], 0, 'f', 1)
               .arg(100 * best.measures[Measure::Narrow], 0, 'f', 1)
               .arg(100 * best.measures[Measure::Coverage], 0, 'f', 1)
               .arg(100 * best.measures[Measure::Quality], 0, 'f', 1)
               .arg(previews / previewing, 0, 'f', 0);
    for (const Immersion& immersion : best.immersions) {
        out << QStringLiteral(" rotation=%1;%2;%3,offset=%4;%5")
                   .arg(immersion.rotation[0].value())
                   .arg(immersion.rotation[1].value())
                   .arg(immersion.rotation[2].value())
                   .arg(immersion.offset[0].value())
                   .arg(immersion.offset[1].value());
    }
    out << "\n";
    out.flush();
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication app(argc, argv);
    QTextStream out(stdout);
    const bench::Arguments arguments(argc, argv);
    const QString solver = QString::fromStdString(arguments.value("solver", "auto"));
    SearchSettings settings;
    for (const auto& [name, number] : {std::pair("immersions", &settings.immersions),
                                       {"directions", &settings.directions},
                                       {"candidates", &settings.simulated},
                                       {"refined", &settings.refined},
                                       {"finer", &settings.finer},
                                       {"confirmed", &settings.confirmed}}) {
        *number = arguments.number(name, *number);
    }
    for (const auto& [name, value] : arguments.values()) {
        if (name.starts_with("weight.")) {
            setWeight(settings.aims, QString::fromStdString(name.substr(7)),
                      std::atof(value.c_str()));
        }
    }
    const SolverRegistry registry;
    for (const std::string& path : arguments.words()) {
        measure(QString::fromStdString(path), solver, settings, registry, out);
    }
    return 0;
}

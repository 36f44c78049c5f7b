// How long a pose search takes, and what it finds:
//   pose_search_bench [solver=ID] [immersions=1|2] [directions=N] [candidates=N] [refined=N]
//                     [finer=N] [confirmed=N] [weight.MEASURE=X] JOB.dipw…
// A line a project: seconds on the clock and of all processors, dips, the objective of the best
// poses and of the project's own, the share that is certain of what the best paint, the share of
// their join that is too narrow, and the best.
// And how many times a second coverage is previewed, on one thread.
#include "model/TexturedMesh.h"
#include "pipeline/JobSearch.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "search/CoveragePreview.h"
#include "solver/SolverRegistry.h"

#include <QGuiApplication>
#include <QTextStream>

#include <chrono>
#include <ctime>

using namespace dipwright;

namespace {

void measure(const QString& path, const QString& solver, const SearchSettings& settings,
             const SolverRegistry& registry, QTextStream& out) {
    const Project project = loadProject(path);
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t clock = std::clock();
    int dips = 0;
    const SearchResult result =
        searchPoses(searchSubject(project, solver), settings, registry.module(solver), {},
                    [&](const SearchState& state) { dips = state.done; }, {});
    const double processors = double(std::clock() - clock) / CLOCKS_PER_SEC;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const CoveragePreview preview(project.model->mesh);
    const auto beforePreviews = std::chrono::steady_clock::now();
    constexpr int previews = 50;
    for (int turn = 0; turn < previews; ++turn) {
        Immersion immersion;
        immersion.rotation = {Degrees(7 * turn), Degrees(0), Degrees(3 * turn)};
        preview.ofModel(preview.at(immersion, project.film, project.process));
    }
    const double aSecond =
        previews /
        std::chrono::duration<double>(std::chrono::steady_clock::now() - beforePreviews).count();
    const RankedPoses& best = result.ranking.front();
    out << QStringLiteral("%1, %2 dips to plan: %3 s, %4 s of all processors, %5 dips; objective "
                          "%6, the project's %7; certain %8 %, narrow overlap %9 %, coverage %10 "
                          "%, quality %11 %; %12 previews a second;")
               .arg(project.name)
               .arg(settings.immersions)
               .arg(seconds, 0, 'f', 2)
               .arg(processors, 0, 'f', 1)
               .arg(dips)
               .arg(best.objective, 0, 'f', 4)
               .arg(result.current ? result.current->objective : 0, 0, 'f', 4)
               .arg(100 * best.measures[Measure::Certain], 0, 'f', 1)
               .arg(100 * best.measures[Measure::Narrow], 0, 'f', 1)
               .arg(100 * best.measures[Measure::Coverage], 0, 'f', 1)
               .arg(100 * best.measures[Measure::Quality], 0, 'f', 1)
               .arg(aSecond, 0, 'f', 0);
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
    QString solver = QStringLiteral("auto");
    SearchSettings settings;
    const SolverRegistry registry;
    for (const QString& argument : QCoreApplication::arguments().mid(1)) {
        const QString name = argument.section(QLatin1Char('='), 0, 0);
        const QString value = argument.section(QLatin1Char('='), 1);
        const std::array<std::pair<const char*, int*>, 6> numbers{
            {{"immersions", &settings.immersions},
             {"directions", &settings.directions},
             {"candidates", &settings.simulated},
             {"refined", &settings.refined},
             {"finer", &settings.finer},
             {"confirmed", &settings.confirmed}}};
        const auto number = std::find_if(numbers.begin(), numbers.end(), [&](const auto& each) {
            return name == QLatin1String(each.first);
        });
        if (name == QLatin1String("solver")) {
            solver = value;
        } else if (name.startsWith(QLatin1String("weight."))) {
            setWeight(settings.aims, name.mid(7), value.toDouble());
        } else if (number != numbers.end()) {
            *number->second = value.toInt();
        } else {
            measure(argument, solver, settings, registry, out);
        }
    }
    return 0;
}

#include "pipeline/JobTolerances.h"

#include "base/Error.h"
#include "pipeline/FilmRefinement.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SolverChoice.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr double fieldDone = 0.05;
constexpr float mostColour = 0.5f; // least share with which a place counts for the dip

} // namespace

JobTolerances jobTolerances(const JobResult& result, const ToleranceSettings& settings,
                            const SolverRegistry& registry, const Progress& progress) {
    const Project& project = result.project;
    SolverChoice solver = chooseSolver(result.chosenSolver, registry, progress.cancelToken);
    const SolverInfo& dipped = result.immersions.front().solver;
    if (dipped.id == result.chosenSolver && dipped.id != solver.solver.id) {
        throw Error(Text::tr("The dips were simulated on another computer by %1, which is not "
                             "available here. Run the job here before you compute tolerances")
                        .arg(dipped.name),
                    project.name);
    }
    const auto field = distanceFieldOf(result, progress.part(0, fieldDone));
    JobTolerances tolerances;
    const double part = (1 - fieldDone) / double(result.immersions.size());
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        const ImmersionResult& immersion = result.immersions[number];
        std::function<bool(const SurfacePoint&)> isPainted;
        if (result.share) {
            isPainted = [share = result.share->of(number)](const SurfacePoint& point) {
                return share.at(point) >= mostColour;
            };
        }
        const FilmSettings film = filmOf(immersion, project);
        const double begin = fieldDone + part * double(number);
        tolerances.dips.push_back(
            withFallback(solver, registry, [&](const solver::SolverModule& module) {
                return dipTolerances({*project.model, immersion.immersion, film, project.process,
                                      *field, immersion.laid, isPainted, module},
                                     settings, progress.part(begin, begin + part));
            }));
    }
    std::vector<const DipTolerances*> dips;
    for (const DipTolerances& dip : tolerances.dips) {
        dips.push_back(&dip);
    }
    const std::vector<SurfacePoint> places = tolerancePlaces(*project.model);
    std::vector<std::vector<float>> errors;
    for (const ImmersionResult& dip : result.immersions) {
        errors.push_back(dip.numericalError
                             ? numericalErrorAt(*dip.numericalError, *dip.laid, places)
                             : std::vector<float>());
    }
    tolerances.zones = zoneVerdicts(project.model, dips, errors, settings, result.mask.get());
    return tolerances;
}

} // namespace dipwright

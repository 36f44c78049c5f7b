#include "pipeline/DeeperDip.h"

#include "dip/Dip.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SolverChoice.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

constexpr double fieldDone = 0.1;

ProcessSettings deeperProcess(ProcessSettings process, const PosedBody& body) {
    const Millimetres whole(body.height + process.margin.value());
    process.depth = std::max(
        *process.depth, std::min(whole, Millimetres(process.depth->value() + mostDeeper.value())));
    return process;
}

} // namespace

std::shared_ptr<const LaidFilm> deeperDip(const JobResult& result, std::size_t immersion,
                                          const SolverRegistry& registry,
                                          const Progress& progress) {
    const Project& project = result.project;
    const ImmersionResult& dip = result.immersions[immersion];
    SolverChoice solver = chooseSolver(result.chosenSolver, registry, progress.cancelToken);
    const auto field = distanceFieldOf(result, progress.part(0, fieldDone));
    progress(fieldDone, QCoreApplication::translate("Pipeline", "Simulating a deeper dip"));
    const ProcessSettings process = deeperProcess(project.process, *dip.body);
    const solver::FilmGrid& grid = dip.laid->film().grid;
    const FilledField filled(*dip.body, fieldForFilm(*field, grid, progress.silent()));
    std::vector<solver::BatchItem> dips(1);
    dips[0].setup = dipSetup(*dip.body, filled, dip.immersion, project.film, grid, process);
    withFallback(solver, registry, [&](const solver::SolverModule& module) {
        simulateDips(dips, module, [&] { return progress.cancelToken.isCancelled(); });
    });
    return layFilm(dip.body, dippedFilm(dips[0], dip.immersion), process);
}

} // namespace dipwright

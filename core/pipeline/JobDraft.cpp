#include "pipeline/JobDraft.h"

#include "accuracy/error/SheetChange.h"
#include "dip/FilmUnderBody.h"
#include "film/FilmGrid.h"
#include "pipeline/Pipeline.h"
#include "results/Results.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double coarsestResolution = 50; // dpi of the coarsest draft; doubled by each further one
constexpr double coarsestPictures = 0.15; // size of its proof, relative to a proof of full size

int cellsAlong(const solver::FilmGrid& grid) {
    return std::max(grid.columns, grid.rows) - 1;
}

// Returns the films of all dips.
std::vector<solver::FilmGrid> filmsOf(const Project& project, const ProofStage* stage) {
    if (!isGraded(project.film)) {
        return {filmGrid(project.film)};
    }
    const TriangleMesh& mesh = project.model->mesh;
    const auto own = stage ? nullptr : std::make_unique<SurfaceQuery>(mesh);
    std::vector<solver::FilmGrid> films;
    for (const Immersion& immersion : project.immersions) {
        const Underside underside =
            undersideOf(mesh, stage ? queryOf(*stage) : *own, immersion, project.process);
        films.push_back(filmUnderBody(project.film, underside, immersion.offset));
    }
    return films;
}

// Returns the levels of a job on a GPU, whose films have at most `points` points.
DraftLevels levelsOnGpu(std::size_t points) {
    DraftLevels levels{0, 0};
    for (; points > mostDraftPoints; points /= 4) {
        ++levels.coarsest;
    }
    return levels.coarsest > 0 ? levels : DraftLevels{1, 1};
}

// Returns `project` with the cells and the resolution of the draft `level`.
Project draftProject(Project project, int level, const DraftLevels& levels) {
    const double scale = level > levels.ownFilm ? std::ldexp(1.0, level) : 1;
    project.film.refinement /= scale;
    project.process.timeStep = Seconds(scale * project.process.timeStep.value());
    project.sheet.resolution = DotsPerInch(std::min(
        project.sheet.resolution.value(), std::ldexp(coarsestResolution, levels.coarsest - level)));
    return project;
}

} // namespace

void JobDrafts::add(int level, std::shared_ptr<const JobResult> result) {
    if (result) {
        newest_ = std::max(level, 0);
        results_[newest_] = std::move(result);
    }
}

std::shared_ptr<const JobResult> JobDrafts::reusable(const Project& project, int level) const {
    const auto own = results_.find(std::max(level, 0));
    const auto newest = results_.find(newest_);
    if (own == results_.end() || own == newest) {
        return newest == results_.end() ? nullptr : newest->second;
    }
    auto result = std::make_shared<JobResult>(*own->second);
    const JobResult& newer = *newest->second;
    if (!result->field) {
        result->field = newer.field;
        result->fieldInputs = newer.fieldInputs;
    }
    if (newer.project.model == result->project.model) {
        result->fine = newer.fine;
        result->proofStage = newer.proofStage;
    }
    const std::size_t count = std::min(project.immersions.size(), newer.immersions.size());
    result->immersions.resize(std::max(result->immersions.size(), count));
    for (std::size_t number = 0; number < count; ++number) {
        const BodyInputs wanted = bodyInputs(project, number);
        if (result->immersions[number].inputs.texture.dip.body != wanted &&
            newer.immersions[number].inputs.texture.dip.body == wanted) {
            result->immersions[number] = newer.immersions[number];
        }
    }
    return result;
}

DraftLevels draftLevels(const Project& project, const SolverRegistry& registry,
                        const JobDrafts& earlier) {
    const std::shared_ptr<const JobResult> known = earlier.reusable(project, 0);
    const bool fits = known && known->project.model == project.model;
    int fewestCells = maximumFilmGrid;
    std::size_t mostPoints = 0;
    for (const solver::FilmGrid& film :
         filmsOf(project, fits ? known->proofStage.get() : nullptr)) {
        fewestCells = std::min(fewestCells, cellsAlong(film));
        mostPoints = std::max(mostPoints, film.pointCount());
    }
    DraftLevels levels;
    for (int cells = fewestCells / 2; cells >= fewestDraftCells; cells /= 2) {
        ++levels.coarsest;
    }
    const bool isOnGpu = registry.info(project.process.solver).deviceKind == QLatin1String("gpu");
    return isOnGpu && levels.coarsest > 0 ? levelsOnGpu(mostPoints) : levels;
}

JobResult runLevel(const Project& project, int level, const DraftLevels& levels,
                   const SolverRegistry& registry, const JobDrafts& earlier,
                   const Progress& progress, decltype(JobOptions::observer) observer) {
    const std::shared_ptr<const JobResult> previous = earlier.reusable(project, level);
    JobOptions options;
    if (level <= 0) {
        options.refines = level == refinedLevel;
        options.observer = std::move(observer);
        return runJob(project, registry, options, previous.get(), progress);
    }
    options.estimatesNumericalError = false;
    options.draftPictures = std::min(1.0, std::ldexp(coarsestPictures, levels.coarsest - level));
    return runJob(draftProject(project, level, levels), registry, options, previous.get(),
                  progress);
}

bool canBeRefined(const JobResult& result) {
    return std::any_of(result.immersions.begin(), result.immersions.end(),
                       [](const ImmersionResult& dip) { return dip.finer.has_value(); });
}

std::optional<double> movesSince(const JobResult& coarser, const JobResult& result) {
    std::optional<double> most;
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        const LaidFilm& laid = *result.immersions[number].laid;
        if (laid.film().grid.pointCount() ==
            coarser.immersions[number].laid->film().grid.pointCount()) {
            continue;
        }
        const SheetChange change = sheetChange(
            sheetMoves(laid, *coarser.immersions[number].laid, comparedPlaces(laid.body().mesh)));
        if (change.painted > 0) {
            most = std::max(most.value_or(0), change.distance.percentile95);
        }
    }
    return most;
}

} // namespace dipwright

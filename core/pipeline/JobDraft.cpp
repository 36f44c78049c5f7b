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

// Returns the fewest cells along the longer edge among the films of all dips.
int cellsOf(const Project& project, const ProofStage* stage) {
    if (!isGraded(project.film)) {
        return cellsAlong(filmGrid(project.film));
    }
    const TriangleMesh& mesh = project.model->mesh;
    const auto own = stage ? nullptr : std::make_unique<SurfaceQuery>(mesh);
    int fewest = maximumFilmGrid;
    for (const Immersion& immersion : project.immersions) {
        const Underside underside =
            undersideOf(mesh, stage ? queryOf(*stage) : *own, immersion, project.process);
        fewest =
            std::min(fewest, cellsAlong(filmUnderBody(project.film, underside, immersion.offset)));
    }
    return fewest;
}

// Returns `project` with the cells and the resolution of the draft `level`, of `coarsest` levels.
Project draftProject(Project project, int level, int coarsest) {
    const double scale = std::ldexp(1.0, level);
    project.film.refinement /= scale;
    project.process.timeStep = Seconds(scale * project.process.timeStep.value());
    project.sheet.resolution = DotsPerInch(std::min(
        project.sheet.resolution.value(), std::ldexp(coarsestResolution, coarsest - level)));
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

int coarsestDraft(const Project& project, const JobDrafts& earlier) {
    const std::shared_ptr<const JobResult> known = earlier.reusable(project, 0);
    const bool fits = known && known->project.model == project.model;
    int level = 0;
    for (int cells = cellsOf(project, fits ? known->proofStage.get() : nullptr) / 2;
         cells >= fewestDraftCells; cells /= 2) {
        ++level;
    }
    return level;
}

JobResult runLevel(const Project& project, int level, int coarsest, const SolverRegistry& registry,
                   const JobDrafts& earlier, const Progress& progress,
                   decltype(JobOptions::observer) observer) {
    const std::shared_ptr<const JobResult> previous = earlier.reusable(project, level);
    JobOptions options;
    if (level <= 0) {
        options.refines = level == refinedLevel;
        options.observer = std::move(observer);
        return runJob(project, registry, options, previous.get(), progress);
    }
    options.estimatesNumericalError = false;
    options.draftPictures = std::min(1.0, std::ldexp(coarsestPictures, coarsest - level));
    return runJob(draftProject(project, level, coarsest), registry, options, previous.get(),
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
        const SheetChange change = sheetChange(
            sheetMoves(laid, *coarser.immersions[number].laid, comparedPlaces(laid.body())));
        if (change.painted > 0) {
            most = std::max(most.value_or(0), change.distance.percentile95);
        }
    }
    return most;
}

} // namespace dipwright

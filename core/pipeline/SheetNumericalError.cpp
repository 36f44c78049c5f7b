#include "pipeline/SheetNumericalError.h"

#include "accuracy/error/SheetDifference.h"
#include "base/Error.h"
#include "base/Png.h"
#include "dip/Dip.h"
#include "dip/FilmUnderBody.h"
#include "dip/LaidFilm.h"
#include "disk/FolderTransaction.h"
#include "film/FilmGrid.h"
#include "pipeline/FilmRefinement.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SameSheets.h"
#include "pipeline/SolverChoice.h"
#include "project/FilmSizes.h"
#include "project/Project.h"
#include "results/Results.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <tuple>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr int mapEdge = 1600; // pixels

// Progress as a fraction of the time: after the field, then after the first and the second film of
// an immersion. The third film has twice as many points per side and takes most of the time.
constexpr double fieldDone = 0.02;
constexpr double jobDone = 0.1; // of all progress, if the job's films may be refined
// Sizes of the pictures and sheets of this job. Nobody sees them, so they are small.
constexpr double smallestPictures = 0.1;
constexpr DotsPerInch smallestResolution{50};
constexpr double ownDone = 0.1;
constexpr double halfStepDone = 0.3;
constexpr double dipDone = 0.9; // as a fraction of one film's time

Project withHalfStep(Project project) {
    project.process.contactTravel /= 2;
    project.process.timeStep = Seconds(project.process.timeStep.value() / 2);
    return project;
}

// Smaller cells also shorten the steps, because the production film's steps are given in cells.
Project withHalfSpacing(Project project) {
    FilmSettings& film = project.film;
    film.refinement *= 2;
    if (const solver::FilmGrid finer = filmGrid(film);
        !isGraded(film) && !mayHavePoints(finer.columns, finer.rows)) {
        throw Error(Text::tr("The check of the numerical error would need a film of %1 × %2 "
                             "points, which is too many; halve the number of film points")
                        .arg(finer.columns)
                        .arg(finer.rows),
                    QStringLiteral("film.points"));
    }
    project.process.timeStep = Seconds(project.process.timeStep.value() / 2);
    return project;
}

DipNumericalError numericalError(const Project& project, const Immersion& immersion,
                                 const DistanceField& field, const solver::SolverModule& module,
                                 const Progress& progress) {
    const auto body = std::make_shared<const PosedBody>(
        posedBody(project.model->mesh, immersion, project.process));
    const std::vector<SurfacePoint> places = comparedPlaces(*body);
    // Returns the change at all places and the change at the unmarked places.
    const auto changes = [&](const LaidFilm& own, const LaidFilm& finer) {
        const std::vector<float> moves = sheetMoves(own, finer, places);
        return std::pair(sheetChange(moves), sheetChange(unmarkedMoves(moves, own, places)));
    };
    const auto laid = [&](const Project& job, const Progress& part) {
        DippedFilm film = simulateDip(*body, field, immersion, job.film, job.process, module,
                                      part.part(0, dipDone), {});
        part(dipDone, Text::tr("Comparing the sheets"));
        return layFilm(body, std::move(film), job.process);
    };
    const auto own = laid(project, progress.part(0, ownDone));
    DipNumericalError result;
    result.immersion = immersion;
    std::tie(result.halfStep, result.unmarkedHalfStep) =
        changes(*own, *laid(withHalfStep(project), progress.part(ownDone, halfStepDone)));
    const auto finer = laid(withHalfSpacing(project), progress.part(halfStepDone, 1));
    std::tie(result.halfSpacing, result.unmarkedHalfSpacing) = changes(*own, *finer);
    result.moves = pointMoves(*own, *finer);
    result.laid = own;
    return result;
}

// Returns the projects of single dips, with the cells that the job uses for their sheets.
std::vector<Project> dipsOf(const Project& project, const SolverRegistry& registry,
                            const JobResult* known, const Progress& progress) {
    std::vector<Project> dips;
    std::optional<JobResult> job;
    if (isRefinable(project.film)) {
        JobOptions options;
        options.draftPictures = smallestPictures;
        options.refines = !(known && makeSameSheets(known->project, project));
        Project small = project;
        small.sheet.resolution = smallestResolution;
        job = runJob(small, registry, options, known, progress);
    }
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        Project& dip = dips.emplace_back(project);
        dip.immersions = {project.immersions[number]};
        dip.film = job ? filmOf(job->immersions[number], project) : project.film;
    }
    return dips;
}

} // namespace

QJsonObject toJson(const SheetChange& change) {
    return {{"mean_mm", change.distance.mean},
            {"p95_mm", change.distance.percentile95},
            {"max_mm", change.distance.maximum},
            {"painted", change.painted},
            {"painted_once", change.paintedOnce}};
}

QImage mapOf(const DipNumericalError& numericalError, LengthUnit unit) {
    return numericalErrorMap(*numericalError.laid, numericalError.moves, mostHalfSpacingChange,
                             mapEdge, unit);
}

bool isAccurateEnough(const DipNumericalError& numericalError) {
    return isAccurateEnough(numericalError.halfStep, mostHalfStepChange) &&
           isAccurateEnough(numericalError.halfSpacing, mostHalfSpacingChange);
}

std::vector<DipNumericalError> sheetNumericalError(const Project& project,
                                                   const SolverRegistry& registry,
                                                   const Progress& progress,
                                                   const JobResult* known) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model; import one first"), project.name);
    }
    withHalfSpacing(project); // throws before any work if the film is too fine
    const bool mayBeRefined = isRefinable(project.film);
    const std::vector<Project> dips =
        dipsOf(project, registry, known, progress.part(0, mayBeRefined ? jobDone : 0));
    const Progress checks = progress.part(mayBeRefined ? jobDone : 0, 1);
    SolverChoice solver = chooseSolver(project.process.solver, registry, progress.cancelToken);
    const auto field = cachedDistanceField(project.model->mesh, project.fieldResolution,
                                           checks.part(0, fieldDone));
    std::vector<DipNumericalError> result;
    const double share = (1 - fieldDone) / double(dips.size());
    for (const Project& dip : dips) {
        const double begin = fieldDone + share * double(result.size());
        const Progress part = checks.part(begin, begin + share);
        result.push_back(withFallback(solver, registry, [&](const solver::SolverModule& module) {
            return numericalError(dip, dip.immersions.front(), *field, module, part);
        }));
        result.back().notes = std::exchange(solver.notes, {});
    }
    return result;
}

namespace {

// Returns the names of both maps. A check of a single immersion also removes the second map of an
// earlier check.
QStringList mapNames() {
    return {QStringLiteral("certainty-1.png"), QStringLiteral("certainty-2.png")};
}

} // namespace

void checkMapFolder(const QString& folder) {
    const FolderTransaction trial(folder, mapNames());
}

void writeNumericalErrorMaps(const std::vector<DipNumericalError>& numericalError,
                             const QString& folder) {
    const QStringList names = mapNames();
    FolderTransaction results(folder, names);
    for (std::size_t number = 0; number < numericalError.size(); ++number) {
        const QString& name = names[qsizetype(number)];
        results.write(name, pngBytes(mapOf(numericalError[number]), name));
    }
    results.commit();
}

QJsonObject numericalErrorJson(const std::vector<DipNumericalError>& numericalError) {
    QJsonArray immersions;
    for (const DipNumericalError& one : numericalError) {
        immersions.append(QJsonObject{
            {"name", one.immersion.name},
            {"certain", isAccurateEnough(one)},
            {"half_step", toJson(one.halfStep)},
            {"half_spacing", toJson(one.halfSpacing)},
            {"unmarked", QJsonObject{{"half_step", toJson(one.unmarkedHalfStep)},
                                     {"half_spacing", toJson(one.unmarkedHalfSpacing)}}}});
    }
    return {{"version", 1}, {"immersions", immersions}};
}

} // namespace dipwright

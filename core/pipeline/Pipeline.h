// model → field → dip → texture → sheet: the main job as steps, each fresh, running, done,
// cancelled or out of date, so that an edit recomputes just what it must.
#pragma once

#include "project/Project.h"
#include "results/Results.h"
#include "solver/SolverRegistry.h"

namespace dipwright {

struct ImmersionResult {
    Immersion immersion;
    std::shared_ptr<const PosedBody> body;
    std::shared_ptr<const SurfaceQuery> query;
    std::shared_ptr<const DippedFilm> film;
    std::shared_ptr<const FilmContact> contact;
    std::shared_ptr<const Coverage> coverage;
    std::shared_ptr<const ReverseTexture> texture;
    Registration registration;
    Sheet sheet;
};

struct JobResult {
    SolverInfo solver;
    std::vector<ImmersionResult> immersions;
    double coverageTotal = 0;
    QImage proof;
};

struct JobOptions {
    QString solver;                // overrides the project's, or empty
    QImage filmImage;              // on the film instead of the reverse texture; null: reverse
    bool chessboard = false;       // the built-in 17 mm chessboard as film image
    // Called from the working thread with the immersion's number.
    std::function<void(std::size_t, const FilmFrame&)> observer;
};

// Runs the main job with what can be reused of `previous` (may be null): steps whose inputs did not
// change are taken over. Throws Error or Cancelled. Pure: touches no file but the field cache.
JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress);

// Writes every file of interfaces.md into `folder`: into a temporary folder first, moved in place
// at the end, so that nothing half-written stays behind. Throws Error.
void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress);

QJsonObject report(const Project& project, const JobResult& result);

} // namespace dipwright

// model → field → dip → texture → sheet: the main job, of which an edit recomputes just what it
// must.
#pragma once

#include "project/Project.h"
#include "results/Results.h"
#include "solver/SolverRegistry.h"
#include "texture/Registration.h"

namespace dipwright {

struct ImmersionResult {
    Immersion immersion;
    std::shared_ptr<const PosedBody> body;
    std::shared_ptr<const LaidFilm> laid;
    std::shared_ptr<const Coverage> coverage;
    std::shared_ptr<const ReverseTexture> texture;
    Registration registration;
    Sheet sheet;
};

struct JobOptions {
    QString solver;          // overrides the project's, or empty
    QImage filmImage;        // on the film instead of the reverse texture; null: reverse
    bool chessboard = false; // the built-in chessboard as film image
    // Called from the working thread with the immersion's number.
    std::function<void(std::size_t, const FilmFrame&)> observer;
};

struct JobResult {
    Project project;                            // what was computed
    JobOptions options;                         // and how, without the observer
    SolverInfo solver;                          // that did it
    std::shared_ptr<const DistanceField> field; // null when no dip needed it
    std::vector<ImmersionResult> immersions;
    double coverageTotal = 0; // share of the body's surface that any immersion paints
    QImage proof;
    // Sentences for the user: a solver that failed and which took over, a film past its date
    // or too small.
    QStringList notes;
};

// Edge of the built-in chessboard's squares on the printed sheet, mm (the paper's experiment).
inline constexpr double chessSquare = 17;

// Runs the main job with what can be reused of `previous` (may be null): steps whose inputs did not
// change are taken over. Where a GPU solver fails, the best CPU solver takes over and the notes say
// so. Throws Error or Cancelled. Pure: touches no file but the field cache.
JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress);

// Writes every file of interfaces.md into `folder`, which is made if it is missing: into a
// temporary folder first, moved in place at the end, so that nothing half-written stays behind.
// Earlier results there are replaced, other files are left alone. Throws Error or Cancelled.
void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress);

// Throws Error where writeResults could not write: worth asking before a long job.
void checkResultFolder(const QString& folder);

QJsonObject report(const Project& project, const JobResult& result);

} // namespace dipwright

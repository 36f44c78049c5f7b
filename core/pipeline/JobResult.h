// The result of a run of the main job.
#pragma once

#include "accuracy/numericalError/LawChange.h"
#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"
#include "cradle/Cradle.h"
#include "dip/Coverage.h"
#include "pipeline/StepInputs.h"
#include "project/Project.h"
#include "share/BodyShare.h"
#include "sheet/page/Sheet.h"
#include "solver/SolverRegistry.h"
#include "texture/ReadBack.h"

namespace dipwright {

struct ReverseTexture;

// The result of one dip. Later results share the immutable parts that they take over.
struct ImmersionResult {
    Immersion immersion;
    SheetInputs inputs; // the inputs of everything below
    std::shared_ptr<const PosedBody> body;
    std::shared_ptr<const SurfaceAppearance> appearance; // of the body; null for a cached dip
    SolverInfo solver;       // simulated the dip: the chosen solver, or one that took over
    QStringList solverNotes; // sentences for the user if a solver took over
    std::shared_ptr<const LaidFilm> laid;
    std::shared_ptr<const Coverage> coverage;
    std::shared_ptr<const NumericalErrorEstimate> numericalError; // null: not asked for
    Verdict verdict;                                              // of this dip alone
    std::vector<LawChange> laws;                                  // empty: not asked for
    ReadBackError readBack;
    std::shared_ptr<const ReverseTexture> texture;
    Sheet sheet;
    // mm² of the part that the project's printer leaves visibly too pale
    // (sheet/prepress/Separation.h). None if the printer does not compensate each ink by itself.
    std::optional<double> inkShortfall;
};

// How far the colours of a job may land from their places.
struct JobTolerances {
    std::vector<DipTolerances> dips; // one for each immersion
    std::vector<ZoneVerdict> zones;  // of the existing zones, for all dips together
};

struct JobResult {
    Project project;                             // what was computed
    QString wantedSolver, chosenSolver;          // "auto" or an id, and the id chosen for it
    SolverInfo solver;                           // simulated the last dip
    FieldInputs fieldInputs;                     // of `field`
    std::shared_ptr<const DistanceField> field;  // null when no dip needed it
    PaintInputs paintInputs;                     // of `painted`
    std::shared_ptr<const TexturedMesh> painted; // the model's appearance: texture and artwork
    std::vector<ImmersionResult> immersions;
    std::shared_ptr<const BodyShare> share; // null: each dip paints all that it reaches
    double coverageTotal = 0; // coverage of all dips together: painted share of the surface, 0 … 1
    QImage proof;
    QImage proofWithoutWhite; // null if there is no white or the part has no colour of its own
    QImage coverage;          // shows which dip paints what; null if the dips share nothing
    std::shared_ptr<const JobTolerances> tolerances; // null: not asked for
    Verdict verdict;                                 // about all dips together
    std::vector<Cradle> cradles;                     // of each immersion; empty: not asked for
    QStringList notes; // sentences for the user: a solver took over, the film has expired, …
};

// Returns the id of the solver that `wanted` stands for. If `result` was run with the same wish, it
// is the solver chosen then; otherwise it is `wanted`. So "auto" equals the id chosen for it.
inline QString solverFor(const QString& wanted, const JobResult& result) {
    return wanted == result.wantedSolver ? result.chosenSolver : wanted;
}

} // namespace dipwright

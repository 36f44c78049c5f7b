// What a run of the main job has come to.
#pragma once

#include "accuracy/certainty/LawChange.h"
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

// Immutable parts are shared with the results that later runs take them over into.
struct ImmersionResult {
    Immersion immersion;
    SheetInputs inputs; // what all of this was made from
    std::shared_ptr<const PosedBody> body;
    std::shared_ptr<const SurfaceAppearance> appearance; // of the body; null: a kept dip's
    SolverInfo solver;       // that dipped the film: the chosen one, or one that took over from it
    QStringList solverNotes; // sentences for the user, where one took over
    std::shared_ptr<const LaidFilm> laid;
    std::shared_ptr<const Coverage> coverage;
    std::shared_ptr<const CertaintyEstimate> certainty; // null: not asked for
    Verdict verdict;                                    // of this dip alone
    std::vector<LawChange> laws;                        // empty: not asked for
    ReadBackError readBack;
    std::shared_ptr<const ReverseTexture> texture;
    Sheet sheet;
    // mm² of the part that the inks of the project's printer leave visibly too pale
    // (sheet/prepress/Separation.h); none: it is no printer of inks that are compensated one by
    // one.
    std::optional<double> inkShortfall;
};

// How far the colours of a job may land off their places.
struct JobTolerances {
    std::vector<DipTolerances> dips; // an immersion each
    std::vector<ZoneVerdict> zones;  // those that there are, of all dips together
};

struct JobResult {
    Project project;                            // what was computed
    QString wantedSolver, chosenSolver;         // "auto" or an id, and the id that it stood for
    SolverInfo solver;                          // that dipped the last immersion's film
    FieldInputs fieldInputs;                    // of `field`
    std::shared_ptr<const DistanceField> field; // null when no dip needed it
    PaintInputs paintInputs;                    // of `painted`
    std::shared_ptr<const TexturedMesh>
        painted; // the model with its artwork, which all bodies wear
    std::vector<ImmersionResult> immersions;
    std::shared_ptr<const BodyShare> share; // null: each dip paints all that it reaches
    double coverageTotal = 0;               // share of the body's surface that any immersion paints
    QImage proof;
    QImage proofWithoutWhite; // null where there is no white, or the part has no colour of its own
    QImage coverage;          // who paints what of a body that is shared out; null of others
    std::shared_ptr<const JobTolerances> tolerances; // null: not asked for
    Verdict verdict;                                 // of what is told of all dips together
    std::vector<Cradle> cradles;                     // of each immersion; empty: not asked for
    QStringList notes; // sentences for the user: a solver that took over, a film past its date or
                       // too small
};

// The id of the solver that a project's `wanted` stands for, as far as `result` tells: the one that
// was chosen for it when it wanted the same; otherwise `wanted` itself. So "auto" and the id that
// "auto" came to are one solver.
inline QString solverFor(const QString& wanted, const JobResult& result) {
    return wanted == result.wantedSolver ? result.chosenSolver : wanted;
}

} // namespace dipwright

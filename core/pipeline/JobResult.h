// The result of a run of the main job.
#pragma once

#include "accuracy/error/LawChange.h"
#include "accuracy/error/NumericalErrorEstimate.h"
#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"
#include "cradle/Cradle.h"
#include "dip/Coverage.h"
#include "pipeline/StepInputs.h"
#include "project/Project.h"
#include "share/BodyShare.h"
#include "sheet/page/Sheet.h"
#include "sheet/prepress/Separation.h"
#include "solver/SolverRegistry.h"
#include "texture/ReadBack.h"

namespace dipwright {

class BodyColours;
struct ProofStage;
struct ReverseTexture;
struct ShareStage;

// The result of one dip. A later result shares the immutable members that it takes over from an
// earlier result.
struct ImmersionResult {
    Immersion immersion;
    SheetInputs inputs; // the inputs of everything below
    std::shared_ptr<const PosedBody> body;
    std::shared_ptr<const SurfaceAppearance>
        appearance;          // appearance of the body; null for a cached dip
    SolverInfo solver;       // that simulated the dip: the chosen one, or the one that took over
    QStringList solverNotes; // sentences for the user if a solver took over
    std::shared_ptr<const LaidFilm> laid;
    double refinement = 1; // the film has this many times the cells of the settings, along an edge
    // Refinement with which the dip is to be repeated (FilmRefinement.h); none: it is fine enough,
    // or smaller cells are not possible.
    std::optional<double> finer;
    QString refinementFailure; // why a dip with smaller cells failed; empty: none has failed
    std::shared_ptr<const Coverage> coverage;
    // The films of the coarser dips, for the numerical error of a finer dip. Null for a
    // cached dip, and after a run if `finer` is none. A finer dip that needs them dips them again.
    std::shared_ptr<const CoarserFilms> coarser;
    std::shared_ptr<const NumericalErrorEstimate> numericalError; // null: not requested
    Verdict verdict;                                              // verdict on this dip alone
    std::vector<LawChange> laws;                                  // empty: not requested
    std::optional<ReadBackError> readBack;                        // none: a draft
    std::shared_ptr<const ReverseTexture> texture;
    Sheet sheet;
    // Area of the part, in mm², that the project's printer leaves visibly too pale
    // (sheet/prepress/Separation.h). None if the inks are not compensated separately.
    std::optional<double> inkShortfall;
    std::vector<InkArea> inks; // that the project's printer takes for the sheet; empty: a draft
    QStringList lostPlates;    // of the sheet (sheet/prepress/Separation.h)
    QString coveredPicture;    // coveredPictureNote() of the sheet; empty: a draft, or none
    QString unusualCorrection; // unusualErrorNote() of the error that the sheet corrects

    // Returns the numerical error if it is known, else null.
    const NumericalErrorEstimate* knownError() const {
        return numericalError && numericalError->isKnown() ? numericalError.get() : nullptr;
    }
};

// How far the colours of a job may land from their places.
struct JobTolerances {
    std::vector<DipTolerances> dips; // one for each immersion
    std::vector<ZoneVerdict> zones;  // one for each existing zone, about all dips together
};

struct JobResult {
    Project project;                              // the project that was computed
    QString wantedSolver, chosenSolver;           // requested: "auto" or an id; chosen: an id
    SolverInfo solver;                            // the solver that simulated the last dip
    FieldInputs fieldInputs;                      // inputs of `field`
    std::shared_ptr<const DistanceField> field;   // null when no dip needed it
    QString thinParts;                            // thinPartNote() of the model and `fieldInputs`
    PaintInputs paintInputs;                      // inputs of `painted`
    std::shared_ptr<const TexturedMesh> painted;  // the model with texture and artwork
    std::shared_ptr<const SurfaceMask> mask;      // surface without film; null: none
    std::shared_ptr<const SeparateBodies> bodies; // of the model; null: one body
    std::vector<ImmersionResult> immersions;
    std::shared_ptr<const BodyShare> share; // null: each dip paints every place that it reaches
    // Prepared from the model or from `painted`, for further results with the same inputs. Null if
    // they were not needed.
    std::shared_ptr<const RefinedMesh> fine; // fineBody() of the model
    std::shared_ptr<const ProofStage> proofStage;
    std::shared_ptr<const ShareStage> shareStage;
    std::shared_ptr<const BodyColours> colours;
    double coverageTotal = 0; // coverage of all dips together: painted share of the surface, 0 … 1
    QImage proof;
    QImage proofWithoutWhite; // null if there is no white or the part has no colour of its own
    QImage coverage; // shows which dip paints which area; null if the dips do not share the body
    std::shared_ptr<const JobTolerances> tolerances; // null: not requested
    Verdict verdict;                                 // verdict on all dips together
    std::vector<Cradle> cradles;                     // one for each immersion; empty: not requested
    QStringList notes; // sentences for the user: a solver took over, the film has expired, …
};

// Returns the id of the solver that `wanted` stands for. If `result` was run with the same
// `wanted`, returns the solver that was chosen then; otherwise returns `wanted`. This resolves
// "auto".
inline QString solverFor(const QString& wanted, const JobResult& result) {
    return wanted == result.wantedSolver ? result.chosenSolver : wanted;
}

} // namespace dipwright

// How far a sheet may be off for numerical reasons, estimated from two coarser dips that together
// take no longer than the dip itself (docs/film-validation.md, "The verdict").
#pragma once

#include "accuracy/certainty/SheetChange.h"
#include "base/Progress.h"
#include "dip/Dip.h"

#include <functional>

namespace dipwright {

// The same dip with film cells, and steps with them, twice as wide, and with steps twice as long on
// the same cells; located on the body.
struct CoarserFilms {
    std::shared_ptr<const LaidFilm> doubleSpacing, doubleStep; // null where `failure` says why
    QString
        failure; // a sentence for the user: a film too coarse to be halved, a solver that failed
};

// Simulates both as a batch, with what the film itself is dipped with. A dip that fails is a
// failure of the comparison and not of the job. Any thread; throws Cancelled soon after
// `isCancelled`, which is asked from one thread at a time, has said so.
CoarserFilms coarserFilms(const std::shared_ptr<const PosedBody>& body, const DistanceField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const ProcessSettings& process, const solver::SolverModule& module,
                          const std::function<bool()>& isCancelled);

// What of the change to a coarser dip is to be expected when the same is made finer: half of it for
// the cells, an error of first order, and all of it for the step, whose error shows no order on
// bodies with limbs. Ours, measured; docs/film-validation.md, "The verdict".
inline constexpr double halfSpacingShare = 0.5;
inline constexpr double halfStepShare = 1;

struct CertaintyEstimate {
    SheetChange doubleSpacing, doubleStep; // as measured
    // How far the sheet may be off: the larger of both changes, which for an error of first order
    // is the distance to the sheet of an infinitely fine film. mm, over points spread evenly over
    // the body, where all three dips paint.
    Distribution offBy;
    // The same of each film point that lies on the body; NaN where not all dips paint, 0 elsewhere.
    std::vector<float> pointsOffBy;
    QString failure; // where nothing could be compared, and all else is empty

    // What half the cell and half the step are expected to change.
    SheetChange halfSpacing() const;
    SheetChange halfStep() const;
};

// Of the film `own`. All cores, deterministic.
CertaintyEstimate certaintyEstimate(const LaidFilm& own, const CoarserFilms& coarser);

// How far the sheet may be off at each of `places` of the body, mm; 0 where `own` does not paint or
// nothing is known. All cores.
std::vector<float> offByAt(const CertaintyEstimate& estimate, const LaidFilm& own,
                           const std::vector<SurfacePoint>& places);

} // namespace dipwright

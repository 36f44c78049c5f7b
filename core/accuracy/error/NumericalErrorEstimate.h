// Estimates the numerical error of a sheet from two coarser dips. Together they take no longer than
// the dip itself (docs/film-validation.md, "The verdict").
#pragma once

#include "accuracy/numericalError/SheetChange.h"
#include "base/Progress.h"
#include "dip/Dip.h"

#include <functional>

namespace dipwright {

// The films of two coarser dips, laid on the body. One has cells and steps twice as long, the other
// has steps twice as long on the same cells.
struct CoarserFilms {
    std::shared_ptr<const LaidFilm> doubleSpacing, doubleStep; // null if `failure` is set
    QString failure; // why there are none, for the user: too few cells, or a solver failed
};

// Simulates both dips as a batch, with the settings of the dip itself. If one fails, only the
// comparison fails, not the job. Any thread. `isCancelled` is called from one thread at a time;
// throws Cancelled soon after it returns true.
CoarserFilms coarserFilms(const std::shared_ptr<const PosedBody>& body, const DistanceField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const ProcessSettings& process, const solver::SolverModule& module,
                          const std::function<bool()>& isCancelled);

// Ratio of the change expected from a finer dip to the change measured with a coarser one. Half for
// the cells, whose error is of first order. One for the step, whose error shows no order on bodies
// with limbs. Chosen by measurement; docs/film-validation.md, "The verdict".
inline constexpr double halfSpacingShare = 0.5;
inline constexpr double halfStepShare = 1;

// The estimated numerical error of one sheet.
struct NumericalErrorEstimate {
    SheetChange doubleSpacing, doubleStep; // as measured
    // Numerical error in mm: the larger of both changes. For an error of first order it is the
    // distance to the sheet of an infinitely fine film. Sampled at points spread evenly over the
    // body, where all three dips paint.
    Distribution offBy;
    // Numerical error of each film point on the body; NaN where not all dips paint, 0 off the body.
    std::vector<float> pointErrors;
    QString failure; // why nothing could be compared; all else is then empty

    // The changes expected from cells and steps half as long.
    SheetChange halfSpacing() const;
    SheetChange halfStep() const;
};

// Estimates the numerical error of the film `own`. All cores, deterministic.
NumericalErrorEstimate estimateNumericalError(const LaidFilm& own, const CoarserFilms& coarser);

// Returns the numerical error at each of `places` on the body, in mm. 0 where `own` does not paint
// or nothing is known. All cores.
std::vector<float> numericalErrorAt(const NumericalErrorEstimate& estimate, const LaidFilm& own,
                                    const std::vector<SurfacePoint>& places);

} // namespace dipwright

// Estimates the numerical error of a sheet from two coarser dips, which together take a fifth of
// the work of the dip itself (docs/film-validation.md, "The verdict").
#pragma once

#include "accuracy/error/SheetChange.h"
#include "base/Progress.h"
#include "dip/Dip.h"

#include <functional>
#include <optional>

namespace dipwright {

// The films of two coarser dips, laid on the body. One dip has cells and steps twice as long; the
// other has these cells and steps four times as long. Their distance field has cells twice as wide
// as the dip's own, unless it has its usual cells (geometry/FinerFields.h).
struct CoarserFilms {
    // Null if `failure` is set, or if that film does not follow the part.
    std::shared_ptr<const LaidFilm> doubleSpacing, doubleStep;
    QString failure; // tells the user why there are no films: too few cells, or a solver failed
};

// A body in the pose of its dip.
struct PosedDip {
    std::shared_ptr<const PosedBody> body;
    Immersion immersion;
};

// Both coarser dips of a dip.
class CoarserDips {
public:
    // Sets the dips up with the settings of the dip itself. `field` must outlive the simulation.
    // Throws Error like filmUnderBody(). Throws Cancelled.
    CoarserDips(PosedDip dip, const DistanceField& field, const FilmSettings& film,
                const ProcessSettings& process, const Progress& progress);

    // Simulates the dips of all `coarser` as one batch. If one of them fails, the comparisons fail,
    // but not the job. Throws Cancelled soon after `isCancelled` returns true.
    static void simulate(const std::vector<CoarserDips*>& coarser,
                         const solver::SolverModule& module,
                         const std::function<bool()>& isCancelled);
    // Lays the simulated dips.
    CoarserFilms laid() const;

private:
    PosedDip dip_;
    ProcessSettings process_;
    std::optional<FilledField> field_;     // until the simulation has ended
    std::vector<solver::BatchItem> items_; // two, or none if there is a failure
    QString failure_;
};

// Change expected from a finer dip, divided by the change measured with the coarser dips. Both
// constants assume an error of first order. The cells of the coarser dips are twice the dip's own;
// their steps are twice and four times as long. Measurements agree with these constants
// (docs/film-validation.md, "The verdict").
inline constexpr double halfSpacingShare = 0.5;
inline constexpr double halfStepShare = 0.25;

// Least numerical error of a place that both films paint, in the film's smallest cells. Films that
// agree more closely do so by chance (docs/film-validation.md, "The least error").
inline constexpr double leastErrorCells = 0.2;

// The estimated numerical error of one sheet.
struct NumericalErrorEstimate {
    // Measured changes: from the dip itself to double cells, and between both coarser dips.
    SheetChange doubleSpacing, doubleStep;
    // Numerical error in mm at evenly spread points of the body that the dip and the dip with
    // double cells paint, by estimateNumericalError(). At least `leastErrorCells`, here and in
    // pointErrors.
    Distribution offBy;
    // Numerical error of each film point on the body; NaN where unknown, 0 off the body.
    std::vector<float> pointErrors;
    QString failure; // why the comparison failed; all other members are then empty

    // Whether the dip and the coarser dips paint places in common. If not, `offBy` says nothing.
    bool isKnown() const;
    // Returns the change expected from cells and steps half as long.
    SheetChange halfSpacing() const;
    // Returns the change expected from steps half as long.
    SheetChange halfStep() const;
};

// The film of the dip that was repeated with smaller cells, and the film with double its cells.
struct FilmsBefore {
    const LaidFilm& own;
    const LaidFilm* doubleSpacing; // null if that film does not follow the part
};

// Estimates the numerical error of the film `own` at each place from how far the sheet moves
// between films of different cells:
//
// - From `coarser` alone, it is the larger of both moves. For an error of first order, the move
//   from double cells is the distance to the sheet of an infinitely fine film, and the move between
//   the coarser films is twice the distance to infinitely short steps.
// - With the films before the refinement (`before`), each place x on the flat film is assumed to
//   depend on the film's cell h as x(h) = x(0) + a h. The line is fitted to the films that paint
//   the place, by least squares with the weights 1 / h². Let h₀ be the cell of `own`. The error is
//   1.5 |a| h₀ plus the noise: the standard deviation from the line, at this cell and in one
//   direction of the sheet. It is at least half the move between the coarser films. If fewer than
//   three films with different cells paint the place, the error is as without films before.
//
// Without the films before, a chance agreement with the coarser films could end the refinement.
// Uses all cores; deterministic.
//
// Source: after L. Eça, M. Hoekstra, A procedure for the estimation of the numerical uncertainty of
// CFD calculations based on grid refinement studies, J. Comput. Phys. 262 (2014). Here, the order
// is always 1, the deviation is assumed to be proportional to the cell, which gives the weights,
// and the distance of `own` from the line is not added (docs/film-validation.md, "The error of a
// refined film").
NumericalErrorEstimate estimateNumericalError(const LaidFilm& own, const CoarserFilms& coarser,
                                              const std::optional<FilmsBefore>& before = {});

// Returns the numerical error at each of `places` on the body, in mm. It is 0 where `own` does not
// paint or the error is unknown. Uses all cores.
std::vector<float> numericalErrorAt(const NumericalErrorEstimate& estimate, const LaidFilm& own,
                                    const std::vector<SurfacePoint>& places);

} // namespace dipwright

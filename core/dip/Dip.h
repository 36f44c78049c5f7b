// Runs a dip from start to end on a solver.
#pragma once

#include "base/Progress.h"
#include "dip/FilledField.h"
#include "dip/FilmFrame.h"
#include "dip/Pose.h"
#include "film/DippedFilm.h"
#include "settings/FilmSettings.h"
#include "settings/ProcessSettings.h"

#include <functional>

namespace dipwright {

// Returns the film's points for a dip: filmUnderBody(), or filmGrid() if the film is not graded.
solver::FilmGrid dipGrid(const PosedBody& body, const Immersion& immersion,
                         const FilmSettings& film, const ProcessSettings& process);
// Returns the distance field for a dip with the film points of `grid`: `own`, or a field of the
// same body with smaller cells (geometry/FinerFields.h). `own` must outlive the result. Throws
// Cancelled.
const DistanceField& fieldForFilm(const DistanceField& own, const solver::FilmGrid& grid,
                                  const Progress& progress);

// Builds the solver's input with the film's points of dipGrid(). `field` must be the body's
// distance field, and must outlive the dip.
solver::DipSetup dipSetup(const PosedBody& body, const FilledField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const ProcessSettings& process);
// Builds the solver's input with the film points of `grid`, which must be a grid of the same film.
solver::DipSetup dipSetup(const PosedBody& body, const FilledField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const solver::FilmGrid& grid, const ProcessSettings& process);

// Simulates dips as a batch and stores each result in its item. Throws Error if the solver fails.
// Throws Cancelled soon after `isCancelled` returns true; only one thread at a time calls it.
void simulateDips(std::vector<solver::BatchItem>& dips, const solver::SolverModule& module,
                  std::function<bool()> isCancelled);
// Returns the film at the end of `dip`. `dip` must have been set up for `immersion`.
DippedFilm dippedFilm(const solver::BatchItem& dip, const Immersion& immersion);
// Whether the simulation stayed stable. In a stable result every coordinate is finite and at most
// ten times the sum of the film's width, its depth and the travel.
bool isStable(const DippedFilm& film, double travel);
// Whether simulateDip() accepts this stable film: the body comes down on the film and leaves some
// film round it, and at least one point adheres.
bool isAccepted(const DippedFilm& dipped, const PosedBody& body, const Immersion& immersion,
                const FilmSettings& film, const ProcessSettings& process);

// Runs the dip on `module`. `field` is the distance field of the body. The working thread calls
// `observer` (may be empty) about thirty times a second, and more often in very short dips. Throws
// Error if the solver fails or the body does not meet the film. When cancelled, finishes the
// running batch of steps (a few milliseconds, or one step) and throws Cancelled.
DippedFilm simulateDip(const PosedBody& body, const DistanceField& field,
                       const Immersion& immersion, const FilmSettings& film,
                       const ProcessSettings& process, const solver::SolverModule& module,
                       const Progress& progress, const FilmObserver& observer);

} // namespace dipwright

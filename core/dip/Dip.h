// One dip from start to end: the solver's run loop as the program sees it.
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

// What a solver is to simulate; with the points of `grid`, of the same film, in place of those that
// filmUnderBody() chooses. `field`: of the body; it must outlive the dip.
solver::DipSetup dipSetup(const PosedBody& body, const FilledField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const ProcessSettings& process);
solver::DipSetup dipSetup(const PosedBody& body, const FilledField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const solver::FilmGrid& grid, const ProcessSettings& process);

// Simulates dips as a batch; their ends are in them. Throws Error when the solver fails, Cancelled
// soon after `isCancelled` has said so, which is asked from one thread at a time.
void simulateDips(std::vector<solver::BatchItem>& dips, const solver::SolverModule& module,
                  std::function<bool()> isCancelled);
// The film as a solver has left it at the end of `dip`, which was set up for `immersion`.
DippedFilm dippedFilm(const solver::BatchItem& dip, const Immersion& immersion);
// Film points may move by much, but not by many times the film and the way the body goes.
bool isStable(const DippedFilm& film, double travel);

// Runs the dip on `module`. `field`: the body's own. `observer` (may be empty) is called from the
// working thread, at most about thirty times a second. Throws Error when the solver fails or the
// body never meets the film; Cancelled within one step, or some milliseconds of steps, of being
// cancelled.
DippedFilm simulateDip(const PosedBody& body, const DistanceField& field,
                       const Immersion& immersion, const FilmSettings& film,
                       const ProcessSettings& process, const solver::SolverModule& module,
                       const Progress& progress, const FilmObserver& observer);

} // namespace dipwright

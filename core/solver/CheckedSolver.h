// A solver whose answers are checked before anything relies on them, because modules are
// third-party code.
#pragma once

#include <dipwright/FilmSolver.h>

#include <functional>
#include <memory>

namespace dipwright {

// A film whose running computation can be abandoned.
class StoppableFilm : public solver::FilmSolver {
public:
    // From now on a running call may throw Cancelled when `isCancelled` returns true. `isCancelled`
    // is called several times a second. In the program's own process, a call cannot be interrupted.
    virtual void stopOn(std::function<bool()> isCancelled) = 0;
};

// Returns the same module with checked answers. It throws std::runtime_error with a message if the
// module returns no film, makes no progress, or moves the body back up. It also throws if the
// module returns an invalid state, mark or number. For a batch, it throws if films are missing, or
// if the batch stopped without being cancelled. Exceptions of the module become std::runtime_error
// with its message. That message and the device's name are shortened as ModuleText.h says. An
// invalid ceiling counts as not measured. The films are StoppableFilms. Most positions are checked
// by callers, who know how far points may move (dip/Dip.h, isStable). peek() returns false if a
// position is not finite. Keeps a reference to the module.
std::unique_ptr<solver::SolverModule> checkedSolver(const solver::SolverModule& module);

// Throws std::runtime_error with a message if `film` is null.
void requireFilm(const solver::FilmSolver* film);

} // namespace dipwright

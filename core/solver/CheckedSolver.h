// A solver whose answers are judged before anything relies on them: modules are other people's.
#pragma once

#include <dipwright/FilmSolver.h>

#include <functional>
#include <memory>

namespace dipwright {

// A film that can be left while it is computing.
class StoppableFilm : public solver::FilmSolver {
public:
    // From now on a call that goes on while `isCancelled` says so may end with Cancelled; it is
    // asked some times a second. Films of the program's own process end when the call does.
    virtual void stopOn(std::function<bool()> isCancelled) = 0;
};

// The same module, but that it throws std::runtime_error with a sentence where the module gives no
// film, does not come forward, goes back, or gives a state, mark or number that cannot be, and
// where the films of a batch are not there, or it was stopped by nobody. Whatever the module throws
// comes as std::runtime_error, with as much of its words as may stand within a sentence
// (ModuleText.h), as do those for its device; a ceiling that cannot be counts as not measured. Its
// films are StoppableFilms. Where points lie is judged by whoever knows how far they may go
// (dip/Dip.h, isStable); films for display in which a point lies nowhere are not shown. Keeps a
// reference to the module.
std::unique_ptr<solver::SolverModule> checkedSolver(const solver::SolverModule& module);

// Throws std::runtime_error with a sentence for null.
void requireFilm(const solver::FilmSolver* film);

} // namespace dipwright

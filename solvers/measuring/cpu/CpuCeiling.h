// What the processor can do at most.
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright {

// As solver::SolverModule::measuredCeiling.
solver::Ceiling cpuCeiling();

} // namespace dipwright

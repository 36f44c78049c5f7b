// Measures the highest performance of the CPU.
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright {

// See solver::SolverModule::measuredCeiling.
solver::Ceiling cpuCeiling();

} // namespace dipwright

// What a GPU can do at most.
#pragma once

#include "common/cuda/Device.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// As solver::SolverModule::measuredCeiling.
solver::Ceiling measuredCeiling(const Device& device);

} // namespace dipwright::cuda

// Measures the highest performance of a GPU.
#pragma once

#include "common/cuda/Device.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// See solver::SolverModule::measuredCeiling.
solver::Ceiling measuredCeiling(const Device& device);

} // namespace dipwright::cuda

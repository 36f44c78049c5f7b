// Runs the production films on the GPU.
#pragma once

#include "common/cuda/Dips.h"

namespace dipwright::cuda {

// Simulates the production film (docs/film-model.md, "The production model"): Lattice::Isotropic on
// Support::Water. Films, bodies and settings may differ. At most productionDipsAtOnce() dips.
std::unique_ptr<Dips> makeProductionDips(const Device& device, Setups setups);
// Returns how many of the first dips can run together: at most one for each multiprocessor, and as
// many as fit into half of the device's free memory; at least one.
std::size_t productionDipsAtOnce(const Device& device, Setups setups);

} // namespace dipwright::cuda

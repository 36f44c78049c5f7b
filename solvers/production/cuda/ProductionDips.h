// Runs the production films on the GPU.
#pragma once

#include "common/cuda/Dips.h"

namespace dipwright::cuda {

// Simulates the production film (docs/film-model.md, "The production model"): Lattice::Isotropic on
// Support::Water.
std::unique_ptr<Dips> makeProductionDips(const Device& device, Setups setups);
// Returns how many dips like this one should run on the device at the same time, for the highest
// speed.
std::size_t productionDipsAtOnce(const Device& device, const solver::DipSetup& setup);

} // namespace dipwright::cuda

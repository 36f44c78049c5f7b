// The production films on the GPU.
#pragma once

#include "common/cuda/Dips.h"

namespace dipwright::cuda {

// The production film (docs/film-model.md, "The production model"): Lattice::Isotropic on
// Support::Water.
std::unique_ptr<Dips> makeProductionDips(const Device& device, Setups setups);
// How many dips like this one the device is best given at the same time.
std::size_t productionDipsAtOnce(const Device& device, const solver::DipSetup& setup);

} // namespace dipwright::cuda

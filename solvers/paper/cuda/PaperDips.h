// The paper's films on the GPU.
#pragma once

#include "common/cuda/Dips.h"

namespace dipwright::cuda {

// The paper's film (docs/film-model.md, "The paper's model"), relaxed by Jacobi sweeps. Throws
// std::invalid_argument for settings that make no dip or that it does not know.
std::unique_ptr<Dips> makePaperDips(const Device& device, Setups setups);
// How many dips like this one fit on the device at the same time.
std::size_t paperDipsAtOnce(const Device& device, const solver::DipSetup& setup);

} // namespace dipwright::cuda

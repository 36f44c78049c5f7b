// Runs the paper's films on the GPU.
#pragma once

#include "common/cuda/Dips.h"

namespace dipwright::cuda {

// Simulates the paper's film (docs/film-model.md, "The paper's model") with Jacobi sweeps. Throws
// std::invalid_argument for invalid or unsupported settings. The dips differ only in their bodies.
std::unique_ptr<Dips> makePaperDips(const Device& device, Setups setups);
// Returns how many of the first dips can run on the device at the same time; at least one.
std::size_t paperDipsAtOnce(const Device& device, Setups setups);

} // namespace dipwright::cuda

// Finds the GPUs of this computer that can share a batch.
#pragma once

#include "common/cuda/Device.h"

#include <vector>

namespace dipwright::cuda {

// Returns `device` and all other GPUs of the same kind. A dip gives the same result on each of
// these GPUs. Creates no CUDA context; never throws.
std::vector<Device> alikeDevices(const Device& device);

} // namespace dipwright::cuda

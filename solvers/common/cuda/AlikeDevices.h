// The GPUs of a computer that a batch can be shared out to.
#pragma once

#include "common/cuda/Device.h"

#include <vector>

namespace dipwright::cuda {

// The device, and all others of this computer that are of its kind, so that it makes no difference
// which of them a dip runs on. Makes no context; never throws.
std::vector<Device> alikeDevices(const Device& device);

} // namespace dipwright::cuda

// The name that the processor gives itself.
#pragma once

#include <string>

namespace dipwright {

// "AMD EPYC 9554", or "CPU" where the processor does not tell.
std::string cpuName();

} // namespace dipwright

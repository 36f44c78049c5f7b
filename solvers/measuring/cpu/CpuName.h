// Returns the name of the CPU.
#pragma once

#include <string>

namespace dipwright {

// Returns, for example, "AMD EPYC 9554", or "CPU" if the CPU does not report a name.
std::string cpuName();

} // namespace dipwright

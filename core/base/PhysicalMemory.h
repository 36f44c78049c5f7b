// The size of this computer's memory.
#pragma once

#include <cstdint>

namespace dipwright {

// Returns bytes; 0 if the system does not tell.
std::int64_t physicalMemory();

} // namespace dipwright

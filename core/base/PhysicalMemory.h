// The size of this computer's memory.
#pragma once

#include <cstdint>

namespace dipwright {

// Returns the size in bytes; 0 if the system does not report it.
std::int64_t physicalMemory();

} // namespace dipwright

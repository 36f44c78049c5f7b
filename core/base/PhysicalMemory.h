// How much memory this computer has.
#pragma once

#include <cstdint>

namespace dipwright {

// In bytes; 0 where the system does not say.
std::int64_t physicalMemory();

} // namespace dipwright

// How long a thread has computed.
#pragma once

#include <chrono>

namespace dipwright {

// Returns the processor time that the calling thread has used. Other programs hardly change it.
std::chrono::nanoseconds threadProcessorTime();

} // namespace dipwright

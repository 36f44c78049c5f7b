// Flushes denormal numbers to zero in this thread while the object exists. A flat resting film is
// full of denormals, and each costs about a hundred cycles.
#pragma once

#if defined(__SSE__) || defined(_M_X64)
#include <immintrin.h>
#endif

namespace dipwright::cpu {

class FlushDenormals {
public:
#if defined(__SSE__) || defined(_M_X64)
    FlushDenormals() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | 0x8040u);
    }
    ~FlushDenormals() {
        _mm_setcsr(before_);
    }
#else
    FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE__) || defined(_M_X64)
private:
    unsigned before_;
#endif
};

} // namespace dipwright::cpu

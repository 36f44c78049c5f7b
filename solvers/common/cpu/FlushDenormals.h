// Denormal numbers as zero while an object of this class lives: a flat resting film is full of
// them, and every one costs a hundred cycles. Per thread.
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

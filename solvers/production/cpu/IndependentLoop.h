// DIPWRIGHT_INDEPENDENT_LOOP tells the compiler that the next loop's iterations are independent and
// can be vectorised.
#pragma once

#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" // sanitizer builds do not vectorise
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#elif defined(_MSC_VER)
#define DIPWRIGHT_INDEPENDENT_LOOP __pragma(loop(ivdep))
#else
#define DIPWRIGHT_INDEPENDENT_LOOP
#endif

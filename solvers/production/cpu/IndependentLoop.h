// DIPWRIGHT_INDEPENDENT_LOOP: the iterations of the next loop do not depend on each other, so that
// the compiler may vectorise it.
#pragma once

#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" // a build with sanitizers leaves them scalar
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#elif defined(_MSC_VER)
#define DIPWRIGHT_INDEPENDENT_LOOP __pragma(loop(ivdep))
#else
#define DIPWRIGHT_INDEPENDENT_LOOP
#endif

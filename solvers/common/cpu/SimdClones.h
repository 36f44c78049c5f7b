// One function, compiled for several instruction sets, the fitting one taken at run time. For plain
// loops over rows that the compiler vectorises; the arithmetic is the same in every clone.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__)
#define DIPWRIGHT_SIMD_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define DIPWRIGHT_SIMD_CLONES
#endif

#if defined(__GNUC__)
#define DIPWRIGHT_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define DIPWRIGHT_ALWAYS_INLINE inline
#endif

// The iterations of the next loop do not depend on each other.
#if defined(__GNUC__) && !defined(__clang__)
#define DIPWRIGHT_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#else
#define DIPWRIGHT_INDEPENDENT_LOOP
#endif

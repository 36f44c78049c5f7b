// Marks functions that a CUDA compiler also builds for the device, and functions of vectorised
// loops.
#pragma once

// Marks a function that runs on the host and on the device.
#if defined(__CUDACC__)
#define DIPWRIGHT_HOST_DEVICE __host__ __device__
#else
#define DIPWRIGHT_HOST_DEVICE
#endif

// Marks a function that all threads of one film call together: a thread team on a GPU, or the
// single thread that steps the film on the CPU.
#if defined(__CUDACC__)
#define DIPWRIGHT_TEAM __device__
#else
#define DIPWRIGHT_TEAM
#endif

// Replaces `inline` for a large function that is called at several places. A GPU has one copy of
// its code: code that is not in the instruction cache takes longer to fetch than to run.
#if defined(__CUDACC__)
#define DIPWRIGHT_CALLED __noinline__
#else
#define DIPWRIGHT_CALLED inline
#endif

// Stands before a loop that a GPU shall not unroll, for the same reason.
#if defined(__CUDA_ARCH__)
#define DIPWRIGHT_ROLLED _Pragma("unroll 1")
#else
#define DIPWRIGHT_ROLLED
#endif

// Marks a function, in place of `inline`, that a loop over many cells calls. GCC does not inline
// larger functions otherwise, and vectorises no loop that calls a function.
#if defined(__CUDACC__)
#define DIPWRIGHT_IN_LOOP inline
#elif defined(_MSC_VER)
#define DIPWRIGHT_IN_LOOP __forceinline
#else
#define DIPWRIGHT_IN_LOOP __attribute__((always_inline)) inline
#endif

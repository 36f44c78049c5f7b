// Marks the shared formulae so that a CUDA compiler builds them for the device as well.
#pragma once

// What works anywhere.
#if defined(__CUDACC__)
#define DIPWRIGHT_HOST_DEVICE __host__ __device__
#else
#define DIPWRIGHT_HOST_DEVICE
#endif

// What is called by all threads that work on one film together: those of a team on a GPU, the one
// that steps the film on the CPU.
#if defined(__CUDACC__)
#define DIPWRIGHT_TEAM __device__
#else
#define DIPWRIGHT_TEAM
#endif

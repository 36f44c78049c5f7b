// Marks functions that a CUDA compiler also builds for the device.
#pragma once

// For functions that run on the host and on the device.
#if defined(__CUDACC__)
#define DIPWRIGHT_HOST_DEVICE __host__ __device__
#else
#define DIPWRIGHT_HOST_DEVICE
#endif

// For functions that all threads of one film call together: a team on a GPU, or the single thread
// that steps the film on the CPU.
#if defined(__CUDACC__)
#define DIPWRIGHT_TEAM __device__
#else
#define DIPWRIGHT_TEAM
#endif

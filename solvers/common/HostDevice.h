// Marks the shared formulae so that a CUDA compiler builds them for the device as well.
#pragma once

#if defined(__CUDACC__)
#define DIPWRIGHT_HOST_DEVICE __host__ __device__
#else
#define DIPWRIGHT_HOST_DEVICE
#endif

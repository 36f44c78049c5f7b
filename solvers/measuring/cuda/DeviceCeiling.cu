#include "measuring/cuda/DeviceCeiling.h"

#include "measuring/LeastSeconds.h"

namespace dipwright::cuda {

namespace {

constexpr int threads = 256;
constexpr int blocksPerMultiprocessor = 8; // enough threads to fill a multiprocessor
constexpr int chains = 8; // enough independent chains to hide an operation's latency
constexpr int rounds = 1 << 15;
constexpr std::size_t quadruples = std::size_t(1) << 25; // groups of four floats: 512 MiB per array

__global__ void multiplyAdd(float* sink) {
    float values[chains];
    for (int i = 0; i < chains; ++i) {
        values[i] = 1 + 0.1f * float(i) + 1e-6f * float(threadIdx.x);
    }
    for (int round = 0; round < rounds; ++round) {
        for (float& value : values) {
            value = fmaf(value, 0.999f, 0.001f);
        }
    }
    float sum = 0;
    for (const float value : values) {
        sum += value;
    }
    if (sum == 0) { // never true; keeps the compiler from removing the loop
        *sink = sum;
    }
}

__global__ void triad(float4* a, const float4* b, const float4* c) {
    const std::size_t stride = std::size_t(gridDim.x) * blockDim.x;
    for (std::size_t i = std::size_t(blockIdx.x) * blockDim.x + threadIdx.x; i < quadruples;
         i += stride) {
        const float4 x = b[i], y = c[i];
        a[i] = {fmaf(3, y.x, x.x), fmaf(3, y.y, x.y), fmaf(3, y.z, x.z), fmaf(3, y.w, x.w)};
    }
}

// Returns the shortest time of `work` on the device, in seconds.
template <typename Work>
double leastSeconds(const Work& work) {
    return numerics::leastSeconds([&] {
        work();
        check(cudaGetLastError());
        check(cudaStreamSynchronize(nullptr));
    });
}

} // namespace

solver::Ceiling measuredCeiling(const Device& device) {
    use(device);
    const auto blocks = unsigned(device.multiprocessors * blocksPerMultiprocessor);
    solver::Ceiling ceiling;
    DeviceArray<float4> a(quadruples), b(quadruples), c(quadruples);
    b.clear();
    c.clear();
    ceiling.bytesPerSecond = 3.0 * sizeof(float4) * double(quadruples) / leastSeconds([&] {
                                 triad<<<4 * blocks, threads>>>(a.data(), b.data(), c.data());
                             });
    auto* sink = reinterpret_cast<float*>(a.data());
    ceiling.flopsPerSecond = 2.0 * chains * rounds * double(blocks) * threads /
                             leastSeconds([&] { multiplyAdd<<<blocks, threads>>>(sink); });
    return ceiling;
}

} // namespace dipwright::cuda

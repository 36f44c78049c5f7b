// Synchronizes the thread blocks that work on one film together.
#pragma once

#include <cstddef>
#include <cstdint>

namespace dipwright::cuda {

// The memory that a team's blocks share on the device. `arrived` must be 0 when a kernel starts.
struct TeamMemory {
    static constexpr int mostBlocks = 256;
    static constexpr int mostValues = 12;

    unsigned arrived = 0;
    std::int64_t values[2][mostBlocks][mostValues] = {}; // integers, or the bits of other numbers
};

// Gives a block access to its team; the object lies in shared memory. All threads of all blocks
// call all members together and in the same order. All blocks must be resident on the device.
class Team {
public:
    static constexpr int threads = 512; // per block
    static constexpr int warps = threads / 32;
    static_assert(TeamMemory::mostBlocks <= threads && TeamMemory::mostValues <= warps);

    __device__ void begin(TeamMemory* memory, int blocks, int block) {
        if (threadIdx.x == 0) {
            memory_ = memory;
            blocks_ = blocks;
            block_ = block;
            barriers_ = 0;
        }
        __syncthreads();
    }

    __device__ int blocks() const { return blocks_; }
    __device__ int block() const { return block_; }
    // The index of this thread in the team, and the number of threads. Loops over a film's points
    // use both.
    __device__ int thread() const { return block_ * threads + int(threadIdx.x); }
    __device__ int threadCount() const { return blocks_ * threads; }

    // A barrier for all blocks. Afterwards all threads see what any thread wrote before it.
    __device__ void barrier() {
        __syncthreads();
        if (threadIdx.x < 32) {
            const unsigned all = (barriers_ + 1) * unsigned(blocks_);
            __syncwarp();
            if (threadIdx.x == 0) {
                ++barriers_;
                arrive(&memory_->arrived);
            }
            while (int(arrived(&memory_->arrived) - all) < 0) { // both may wrap around
            }
        }
        __syncthreads();
    }

    // Replaces `values` in every thread by the team's sum. Acts as a barrier.
    template <int count>
    __device__ void sum(std::int64_t (&values)[count]) {
        sum(values, count);
    }
    // Sums only the first `used` values.
    template <int count>
    __device__ void sum(std::int64_t (&values)[count], int used) {
        reduce<Sum>(values, used);
    }
    // Replaces `values` in every thread by the team's maximum. Acts as a barrier.
    template <int count>
    __device__ void largest(double (&values)[count]) {
        std::int64_t words[count];
#pragma unroll
        for (int i = 0; i < count; ++i) {
            words[i] = __double_as_longlong(values[i]);
        }
        reduce<Largest>(words, count);
#pragma unroll
        for (int i = 0; i < count; ++i) {
            values[i] = __longlong_as_double(words[i]);
        }
    }

private:
    // Counts this block as arrived. Whoever sees the count sees all that the block wrote before.
    __device__ static void arrive(unsigned* count) {
        asm volatile("red.release.gpu.global.add.u32 [%0], 1;" ::"l"(count) : "memory");
    }
    __device__ static unsigned arrived(const unsigned* count) {
        unsigned value;
        asm volatile("ld.acquire.gpu.global.u32 %0, [%1];" : "=r"(value) : "l"(count) : "memory");
        return value;
    }

    // Combines the values of the first `lanes` lanes into lane 0.
    template <typename Join>
    __device__ static std::int64_t overLanes(std::int64_t value, int lanes) {
        const int lane = int(threadIdx.x) % 32;
#pragma unroll
        for (int offset = 16; offset > 0; offset /= 2) {
            const std::int64_t other = __shfl_down_sync(0xffffffff, value, unsigned(offset));
            if (lane + offset < lanes) {
                value = Join::join(value, other);
            }
        }
        return value;
    }

    struct Sum {
        __device__ static std::int64_t join(std::int64_t a, std::int64_t b) { return a + b; }
        __device__ static std::int64_t inWarp(std::int64_t value, int lanes) {
#if __CUDA_ARCH__ >= 800
            // The hardware sums 32-bit integers: three parts of the value whose sums fit.
            constexpr unsigned all = 0xffffffff, part = (1u << 27) - 1;
            const std::int64_t own = int(threadIdx.x) % 32 < lanes ? value : 0;
            const unsigned low = __reduce_add_sync(all, unsigned(own) & part);
            const unsigned middle = __reduce_add_sync(all, unsigned(own >> 27) & part);
            const int high = __reduce_add_sync(all, int(own >> 54));
            return std::int64_t(low) + (std::int64_t(middle) << 27) + (std::int64_t(high) << 54);
#else
            return overLanes<Sum>(value, lanes);
#endif
        }
    };
    struct Largest { // of numbers in double precision
        __device__ static std::int64_t join(std::int64_t a, std::int64_t b) {
            return __longlong_as_double(a) > __longlong_as_double(b) ? a : b;
        }
        __device__ static std::int64_t inWarp(std::int64_t value, int lanes) {
            return overLanes<Largest>(value, lanes);
        }
    };

    template <typename Join, int count>
    __device__ void reduce(std::int64_t (&values)[count], int used) {
        static_assert(count <= TeamMemory::mostValues);
        const int lane = int(threadIdx.x) % 32, warp = int(threadIdx.x) / 32;
#pragma unroll
        for (int i = 0; i < count; ++i) {
            values[i] = i < used ? Join::inWarp(values[i], 32) : 0;
        }
#pragma unroll
        for (int i = 0; i < count; ++i) {
            if (i < used && lane == 0) {
                partial_[warp][i] = values[i];
            }
        }
        __syncthreads();
        std::int64_t(*slots)[TeamMemory::mostValues] = memory_->values[barriers_ % 2];
        if (warp < used) { // one value per warp
            const std::int64_t joined = Join::inWarp(partial_[lane % warps][warp], warps);
            if (lane == 0) {
                slots[block_][warp] = joined;
            }
        }
        barrier();
        if (warp < used) {
            constexpr int most = TeamMemory::mostBlocks / 32;
            std::int64_t found[most]; // all loads are under way before the first is used
#pragma unroll
            for (int k = 0; k < most; ++k) {
                found[k] = slots[min(lane + 32 * k, blocks_ - 1)][warp];
            }
            std::int64_t joined = found[0];
#pragma unroll
            for (int k = 1; k < most; ++k) {
                if (lane + 32 * k < blocks_) {
                    joined = Join::join(joined, found[k]);
                }
            }
            joined = Join::inWarp(joined, min(blocks_, 32));
            if (lane == 0) {
                result_[warp] = joined;
            }
        }
        __syncthreads();
#pragma unroll
        for (int i = 0; i < count; ++i) {
            if (i < used) {
                values[i] = result_[i];
            }
        }
    }

    TeamMemory* memory_;
    int blocks_, block_;
    unsigned barriers_;
    std::int64_t partial_[warps][TeamMemory::mostValues]; // one row per warp of this block
    std::int64_t result_[TeamMemory::mostValues];
};

} // namespace dipwright::cuda

// Lets neighbouring threads of a GPU share a long computation.
#pragma once

#include "common/HostDevice.h"

#include <cstring>
#include <type_traits>

namespace dipwright::numerics {

// Lanes compute the same values together, and each of them a part of what takes long. On a GPU they
// are four neighbouring threads, and two such groups, the sides, work on the same triangle. On a
// CPU there is one lane and one side. Lanes of a side take the same branches between two calls of
// from(); all lanes of a triangle between two calls of fromSide() or wait().
struct Lanes {
#if defined(__CUDA_ARCH__)
    static constexpr int count = 4, sides = 2;

    __device__ static int index() {
        return int(threadIdx.x) % count;
    }
    __device__ static int side() {
        return int(threadIdx.x) / count % sides;
    }
    // Returns the value of lane `lane` of this side.
    __device__ static float from(float value, int lane) {
        return __shfl_sync(mask<count>(), value, lane, count);
    }
    // Returns the value of side `side`.
    template <typename Value>
    __device__ static Value fromSide(const Value& value, int side) {
        static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % 4 == 0);
        unsigned words[sizeof(Value) / 4];
        std::memcpy(words, &value, sizeof value);
        for (unsigned& word : words) {
            word = __shfl_sync(mask<all>(), word, side * count, all);
        }
        Value result;
        std::memcpy(&result, words, sizeof result);
        return result;
    }
    // A barrier: afterwards all lanes see what any lane wrote before.
    __device__ static void wait() {
        __syncwarp(mask<all>());
    }

private:
    static constexpr int all = count * sides;

    template <int group>
    __device__ static unsigned first() {
        return threadIdx.x % 32 / group * group;
    }
    template <int group>
    __device__ static unsigned mask() {
        return ((1u << group) - 1) << first<group>();
    }
#else
    static constexpr int count = 1, sides = 1;

    DIPWRIGHT_HOST_DEVICE static int index() {
        return 0;
    }
    DIPWRIGHT_HOST_DEVICE static int side() {
        return 0;
    }
    template <typename Value>
    DIPWRIGHT_HOST_DEVICE static Value from(Value value, int) {
        return value;
    }
    template <typename Value>
    DIPWRIGHT_HOST_DEVICE static const Value& fromSide(const Value& value, int) {
        return value;
    }
    DIPWRIGHT_HOST_DEVICE static void wait() {}
#endif
};

} // namespace dipwright::numerics

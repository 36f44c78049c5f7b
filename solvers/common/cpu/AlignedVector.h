// Arrays whose memory is aligned to a pair of cache lines.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace dipwright::cpu {

template <typename Value>
struct AlignedAllocator {
    using value_type = Value;
    static constexpr std::align_val_t alignment{128}; // the CPU fetches lines in pairs

    AlignedAllocator() = default;
    template <typename Other>
    AlignedAllocator(const AlignedAllocator<Other>&) {}

    Value* allocate(std::size_t count) {
        return static_cast<Value*>(::operator new(count * sizeof(Value), alignment));
    }
    void deallocate(Value* values, std::size_t) { ::operator delete(values, alignment); }

    bool operator==(const AlignedAllocator&) const = default;
};

template <typename Value>
using AlignedVector = std::vector<Value, AlignedAllocator<Value>>;

} // namespace dipwright::cpu

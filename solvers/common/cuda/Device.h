// Finds the GPU that runs the films, and manages memory on it.
#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace dipwright::cuda {

struct Device {
    int index = 0;
    std::string name;
    int multiprocessors = 0;
    std::size_t sharedBytes = 0; // largest shared memory of a block, bytes
};

// A usable device, or a sentence that says why there is none.
struct DeviceSearch {
    bool found = false;
    Device device;
    std::string reason;
};

// Returns the usable GPU with the most multiprocessors. Creates no CUDA context on it; never
// throws.
DeviceSearch findDevice();

// Throws std::runtime_error with a sentence for the user if `result` is an error.
void check(cudaError_t result);

// Makes the device current in this thread.
void use(const Device& device);

// Memory on the device that was current when the object was made. Movable, not copyable.
template <typename Value>
class DeviceArray {
public:
    DeviceArray() = default;
    explicit DeviceArray(std::size_t count) : count_(count) {
        check(cudaMalloc(reinterpret_cast<void**>(&values_), count * sizeof(Value)));
    }
    explicit DeviceArray(std::span<const Value> values) : DeviceArray(values.size()) {
        check(cudaMemcpy(values_, values.data(), values.size_bytes(), cudaMemcpyHostToDevice));
    }
    DeviceArray(DeviceArray&& other) noexcept
        : values_(std::exchange(other.values_, nullptr)), count_(std::exchange(other.count_, 0)) {}
    DeviceArray& operator=(DeviceArray&& other) noexcept {
        std::swap(values_, other.values_);
        std::swap(count_, other.count_);
        return *this;
    }
    ~DeviceArray() { cudaFree(values_); }

    Value* data() const { return values_; }
    std::size_t size() const { return count_; }

    // Sets all bytes to zero.
    void clear() { check(cudaMemset(values_, 0, count_ * sizeof(Value))); }

private:
    Value* values_ = nullptr;
    std::size_t count_ = 0;
};

} // namespace dipwright::cuda

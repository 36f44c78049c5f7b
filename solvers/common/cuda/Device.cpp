#include "common/cuda/Device.h"

#include <stdexcept>

namespace dipwright::cuda {

namespace {

constexpr int leastCapability = 75; // oldest compute capability that CUDA 13 supports

std::string version(int number) {
    return std::to_string(number / 1000) + "." + std::to_string(number % 1000 / 10);
}

std::string missingDriver() {
    int driver = 0, needed = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&needed);
    if (driver == 0) {
        return "No NVIDIA driver was found on this computer; install one to compute on the GPU.";
    }
    return "The NVIDIA driver is too old: it supports CUDA " + version(driver) + ", and CUDA " +
           version(needed) + " is needed; update the driver.";
}

std::string sentence(cudaError_t error) {
    switch (error) {
    case cudaErrorMemoryAllocation:
        return "the GPU's memory is full; close other programs that use it, reduce the number of "
               "film points, or choose the CPU";
    case cudaErrorInsufficientDriver:
    case cudaErrorNoDevice:
    case cudaErrorDevicesUnavailable:
        return std::string("the GPU cannot be used (") + cudaGetErrorString(error) +
               "); choose the CPU";
    default:
        return std::string("the GPU stopped computing (") + cudaGetErrorString(error) +
               "); start the program again or choose the CPU";
    }
}

// Returns why the device cannot run the films, or an empty string if it can.
std::string unfitness(const cudaDeviceProp& properties) {
    const std::string name = properties.name;
    if (10 * properties.major + properties.minor < leastCapability) {
        return "The GPU " + name +
               " is too old; a GPU of the Turing generation (2018) or newer is needed.";
    }
    if (!properties.cooperativeLaunch) {
        return "The GPU " + name + " cannot run cooperative kernels in this driver mode.";
    }
    return {};
}

} // namespace

DeviceSearch findDevice() {
    DeviceSearch search;
    int count = 0;
    const cudaError_t result = cudaGetDeviceCount(&count);
    if (result == cudaErrorInsufficientDriver) {
        search.reason = missingDriver();
        return search;
    }
    if (result != cudaSuccess || count == 0) {
        search.reason = "No NVIDIA GPU was found on this computer";
        search.reason += result == cudaSuccess || result == cudaErrorNoDevice
                             ? "."
                             : std::string(" (") + cudaGetErrorString(result) + ").";
        return search;
    }
    for (int index = 0; index < count; ++index) {
        cudaDeviceProp properties{};
        if (cudaGetDeviceProperties(&properties, index) != cudaSuccess) {
            continue;
        }
        const std::string reason = unfitness(properties);
        if (!reason.empty()) {
            search.reason = reason;
        } else if (!search.found ||
                   properties.multiProcessorCount > search.device.multiprocessors) {
            search.found = true;
            search.device = {index, properties.name, properties.multiProcessorCount,
                             properties.sharedMemPerBlockOptin};
        }
    }
    if (!search.found && search.reason.empty()) {
        search.reason =
            "The GPU does not respond; restart the computer or update the GPU's driver.";
    }
    return search;
}

void check(cudaError_t result) {
    if (result != cudaSuccess) {
        cudaGetLastError(); // clears the error, so that it is reported only once
        throw std::runtime_error(sentence(result));
    }
}

void use(const Device& device) {
    check(cudaSetDevice(device.index));
}

} // namespace dipwright::cuda

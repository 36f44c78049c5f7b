#include "common/cuda/AlikeDevices.h"

namespace dipwright::cuda {

std::vector<Device> alikeDevices(const Device& device) {
    std::vector<Device> alike{device};
    int count = 0;
    if (cudaGetDeviceCount(&count) != cudaSuccess) {
        return alike;
    }
    for (int index = 0; index < count; ++index) {
        cudaDeviceProp properties{};
        if (index != device.index && cudaGetDeviceProperties(&properties, index) == cudaSuccess &&
            properties.name == device.name && properties.cooperativeLaunch != 0 &&
            properties.multiProcessorCount == device.multiprocessors &&
            properties.sharedMemPerBlockOptin == device.sharedBytes) {
            Device other = device;
            other.index = index;
            alike.push_back(other);
        }
    }
    return alike;
}

} // namespace dipwright::cuda

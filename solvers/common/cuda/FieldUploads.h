// Uploads signed distance fields to the device, each field once for all dips that share it.
#pragma once

#include "common/cuda/Device.h"

#include <dipwright/FilmSolver.h>

#include <map>

namespace dipwright::cuda {

class FieldUploads {
public:
    // Returns the size of a field's samples, bytes.
    static std::size_t bytes(const solver::FieldView& field) {
        return std::size_t(field.size[0]) * std::size_t(field.size[1]) *
               std::size_t(field.size[2]) * sizeof(float);
    }
    // Returns the samples of `field` in device memory. The pointer is valid while this object
    // exists.
    const float* onDevice(const solver::FieldView& field) {
        auto found = samples_.find(field.distance);
        if (found == samples_.end()) {
            const std::size_t count = bytes(field) / sizeof(float);
            found = samples_
                        .emplace(field.distance,
                                 DeviceArray<float>(std::span<const float>(field.distance, count)))
                        .first;
        }
        return found->second.data();
    }

private:
    std::map<const float*, DeviceArray<float>> samples_; // key: the samples' address on the host
};

} // namespace dipwright::cuda

// A film on its way to the host for display while the device computes on.
#pragma once

#include "common/cuda/Dips.h"

#include <memory>
#include <optional>

namespace dipwright::cuda {

// The film is copied on the device between two steps, which takes microseconds, and the copy comes
// over beside the steps that follow.
class Snapshot {
public:
    // Of one film, which must live longer than this.
    Snapshot(const Dips& dips, std::size_t dip);

    // As solver::FilmSolver::peek.
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown);

private:
    template <auto destroy>
    struct Destroyer {
        template <typename Handle>
        void operator()(Handle* handle) const {
            destroy(handle);
        }
    };
    using Event = std::unique_ptr<CUevent_st, Destroyer<cudaEventDestroy>>;

    static Event makeEvent();
    void begin();

    const Dips& dips_;
    std::size_t dip_;
    DeviceArray<std::byte> onDevice_;
    std::unique_ptr<std::byte, Destroyer<cudaFreeHost>> onHost_;
    Event copied_ = makeEvent(), arrived_ = makeEvent();
    std::unique_ptr<CUstream_st, Destroyer<cudaStreamDestroy>>
        way_;                                  // to the host, beside the steps
    std::optional<solver::DipState> underWay_; // the film's when it was copied
};

} // namespace dipwright::cuda

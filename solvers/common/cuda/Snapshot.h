// Copies a film to the host for display while the device continues computing.
#pragma once

#include "common/cuda/Dips.h"

#include <memory>
#include <optional>

namespace dipwright::cuda {

// Copies the film on the device between two steps, which takes microseconds. That copy is
// transferred to the host while the next steps run.
class Snapshot {
public:
    // Takes snapshots of one film. `dips` must outlive this object.
    Snapshot(const Dips& dips, std::size_t dip);

    // See solver::FilmSolver::peek.
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
        way_; // copies to the host while the steps run
    std::optional<solver::DipState>
        underWay_; // state of the dip when the film was copied; empty if no copy is in transfer
};

} // namespace dipwright::cuda

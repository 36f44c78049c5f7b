#include "common/cuda/Snapshot.h"

namespace dipwright::cuda {

Snapshot::Snapshot(const Dips& dips, std::size_t dip)
    : dips_(dips), dip_(dip), onDevice_(dips.stored(dip).bytes) {
    void* memory = nullptr;
    check(cudaMallocHost(&memory, onDevice_.size()));
    onHost_.reset(static_cast<std::byte*>(memory));
    cudaStream_t stream = nullptr;
    check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
    way_.reset(stream);
}

Snapshot::Event Snapshot::makeEvent() {
    cudaEvent_t event = nullptr;
    check(cudaEventCreateWithFlags(&event, cudaEventDisableTiming));
    return Event(event);
}

bool Snapshot::peek(std::span<float> positions, std::span<solver::PointState> states,
                    solver::DipState& shown) {
    use(dips_.device());
    if (!underWay_) {
        begin();
        return false;
    }
    const cudaError_t arrival = cudaEventQuery(arrived_.get());
    if (arrival == cudaErrorNotReady) {
        return false;
    }
    check(arrival);
    shown = *underWay_;
    underWay_.reset();
    dips_.unpack(dip_, onHost_.get(), shown, positions, states);
    return true;
}

void Snapshot::begin() {
    const StoredFilm film = dips_.stored(dip_);
    check(cudaMemcpyAsync(onDevice_.data(), film.onDevice, film.bytes, cudaMemcpyDeviceToDevice));
    check(cudaEventRecord(copied_.get()));
    check(cudaStreamWaitEvent(way_.get(), copied_.get()));
    check(cudaMemcpyAsync(onHost_.get(), onDevice_.data(), film.bytes, cudaMemcpyDeviceToHost,
                          way_.get()));
    check(cudaEventRecord(arrived_.get(), way_.get()));
    underWay_ = dips_.state(dip_);
}

} // namespace dipwright::cuda

#include "common/cuda/Dips.h"

#include <algorithm>
#include <stdexcept>

namespace dipwright::cuda {

Dips::Dips(const Device& device, Setups setups) : device_(device) {
    for (const solver::DipSetup* setup : setups) {
        films_.push_back(setup->film);
    }
}

void Dips::read(std::size_t dip, std::span<float> positions,
                std::span<solver::PointState> states) const {
    use(device_);
    const StoredFilm source = stored(dip);
    std::vector<std::byte> copy(source.bytes);
    check(cudaMemcpy(copy.data(), source.onDevice, source.bytes, cudaMemcpyDeviceToHost));
    unpack(dip, copy.data(), state(dip), positions, states);
}

void Dips::readMarks(std::size_t, std::span<std::uint8_t> marks) const {
    std::fill(marks.begin(), marks.end(), std::uint8_t(0));
}

void Dips::unpack(std::size_t dip, const std::byte* stored, const solver::DipState& dipState,
                  std::span<float> positions, std::span<solver::PointState> states) const {
    const std::size_t count = films_[dip].pointCount();
    if (positions.size() != 3 * count || !(states.empty() || states.size() == count)) {
        throw std::invalid_argument("the arrays to read into do not match the film");
    }
    unpackPoints(dip, stored, dipState, positions, states);
}

} // namespace dipwright::cuda

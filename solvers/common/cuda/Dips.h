// Runs one or several dips together on one GPU.
#pragma once

#include "common/cuda/Device.h"

#include <dipwright/FilmSolver.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace dipwright::cuda {

// The contiguous device memory that holds one film.
struct StoredFilm {
    const std::byte* onDevice = nullptr;
    std::size_t bytes = 0;
};

using Setups = std::span<const solver::DipSetup* const>;

// The films stay on the device. Only one thread may use the object at a time. Device errors are
// thrown as std::runtime_error; after that the object can only be destroyed.
class Dips {
public:
    Dips(const Device& device, Setups setups);
    virtual ~Dips() = default;

    const Device& device() const { return device_; }
    const solver::FilmGrid& film(std::size_t dip) const { return films_[dip]; }

    // Advances each dip that has not finished by at most `maximumSteps` steps.
    virtual void advance(int maximumSteps) = 0;
    virtual solver::DipState state(std::size_t dip) const = 0;
    // See solver::FilmSolver::read.
    void read(std::size_t dip, std::span<float> positions,
              std::span<solver::PointState> states) const;
    // See solver::FilmSolver::readMarks.
    virtual void readMarks(std::size_t dip, std::span<std::uint8_t> marks) const;

    virtual StoredFilm stored(std::size_t dip) const = 0;
    // Decodes `stored`, a host copy of the stored film that was made at `dipState`. Fills the
    // arrays as solver::FilmSolver::read does.
    void unpack(std::size_t dip, const std::byte* stored, const solver::DipState& dipState,
                std::span<float> positions, std::span<solver::PointState> states) const;

private:
    // Does the work of `unpack`. The arrays have the size of the film.
    virtual void unpackPoints(std::size_t dip, const std::byte* stored,
                              const solver::DipState& dipState, std::span<float> positions,
                              std::span<solver::PointState> states) const = 0;

    Device device_;
    std::vector<solver::FilmGrid> films_;
};

} // namespace dipwright::cuda

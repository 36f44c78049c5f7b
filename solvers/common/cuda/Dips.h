// Runs one or several dips together on one GPU. Their films are equal; their bodies may differ.
#pragma once

#include "common/cuda/Device.h"

#include <dipwright/FilmSolver.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace dipwright::cuda {

// The contiguous device memory that holds one film.
struct StoredFilm {
    const std::byte* onDevice = nullptr;
    std::size_t bytes = 0;
};

// The films stay on the device. Only one thread may use the object at a time. Device errors are
// thrown as std::runtime_error; after that the object can only be destroyed.
class Dips {
public:
    Dips(const Device& device, const solver::FilmGrid& film) : device_(device), film_(film) {}
    virtual ~Dips() = default;

    const Device& device() const { return device_; }
    const solver::FilmGrid& film() const { return film_; }

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
    solver::FilmGrid film_;
};

using Setups = std::span<const solver::DipSetup* const>;

// Returns whether one Dips object can run both dips: their films, settings, speeds and field
// spacings are equal.
bool canShareBatch(const solver::DipSetup& a, const solver::DipSetup& b);

} // namespace dipwright::cuda

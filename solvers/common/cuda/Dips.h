// Dips that run together on one GPU: several bodies' ways through several equal films, or just one.
#pragma once

#include "common/cuda/Device.h"

#include <dipwright/FilmSolver.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace dipwright::cuda {

// A film as it lies on the device, in one piece.
struct StoredFilm {
    const std::byte* onDevice = nullptr;
    std::size_t bytes = 0;
};

// The films stay on the device. One object is used by one thread at a time. Errors of the device
// come as std::runtime_error; the object can then only be destroyed.
class Dips {
public:
    Dips(const Device& device, const solver::FilmGrid& film) : device_(device), film_(film) {}
    virtual ~Dips() = default;

    const Device& device() const { return device_; }
    const solver::FilmGrid& film() const { return film_; }

    // Advances each dip that has not finished by at most `maximumSteps` steps.
    virtual void advance(int maximumSteps) = 0;
    virtual solver::DipState state(std::size_t dip) const = 0;
    // As solver::FilmSolver::read.
    void read(std::size_t dip, std::span<float> positions,
              std::span<solver::PointState> states) const;
    // As solver::FilmSolver::readMarks.
    virtual void readMarks(std::size_t dip, std::span<std::uint8_t> marks) const;

    virtual StoredFilm stored(std::size_t dip) const = 0;
    // What a host's copy of the stored film says, made when the dip was at `dipState`; as
    // solver::FilmSolver::read.
    void unpack(std::size_t dip, const std::byte* stored, const solver::DipState& dipState,
                std::span<float> positions, std::span<solver::PointState> states) const;

private:
    // `unpack` into arrays that match the film.
    virtual void unpackPoints(std::size_t dip, const std::byte* stored,
                              const solver::DipState& dipState, std::span<float> positions,
                              std::span<solver::PointState> states) const = 0;

    Device device_;
    solver::FilmGrid film_;
};

using Setups = std::span<const solver::DipSetup* const>;

// Whether two dips can be in one Dips: films and settings are the same but for the body's way.
bool areAlike(const solver::DipSetup& a, const solver::DipSetup& b);

} // namespace dipwright::cuda

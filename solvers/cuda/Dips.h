// Dips that run together on one GPU: several bodies' ways through several equal films, or just one.
#pragma once

#include "cuda/Device.h"

#include <dipwright/FilmSolver.h>

#include <memory>
#include <span>
#include <vector>

namespace dipwright::cuda {

// The films stay on the device. One object is used by one thread at a time. Errors of the device
// come as std::runtime_error; the object can then only be destroyed.
class Dips {
public:
    virtual ~Dips() = default;

    // Advances each dip that has not finished by at most `maximumSteps` steps.
    virtual void advance(int maximumSteps) = 0;
    virtual solver::Progress progress(std::size_t dip) const = 0;
    // As solver::FilmSolver::read.
    virtual void read(std::size_t dip, std::span<float> positions,
                      std::span<solver::PointState> states) const = 0;
};

using Setups = std::span<const solver::DipSetup* const>;

// Whether two dips can be in one Dips: films and settings are the same but for the body's way.
bool areAlike(const solver::DipSetup& a, const solver::DipSetup& b);

// The paper's film (film-physics §1), relaxed by Jacobi sweeps. Throws std::invalid_argument for
// settings that make no dip or that it does not know.
std::unique_ptr<Dips> makePaperDips(const Device& device, Setups setups);
// How many dips like this one fit on the device at the same time.
std::size_t paperDipsAtOnce(const Device& device, const solver::DipSetup& setup);

// The production film (film-physics §2): Lattice::Isotropic on Support::Water.
std::unique_ptr<Dips> makeQuasiStaticDips(const Device& device, Setups setups);
std::size_t quasiStaticDipsAtOnce(const Device& device, const solver::DipSetup& setup);

} // namespace dipwright::cuda

// Dips that are off, done many at once.
#pragma once

#include "accuracy/tolerance/Contributors.h"
#include "base/Progress.h"
#include "dip/LaidFilm.h"

#include <functional>
#include <memory>

namespace dipwright {

// What is dipped, and as it is meant to be.
struct DippedBody {
    const TexturedMesh& model; // as imported, mm
    const Immersion& immersion;
    const ProcessSettings& process;
    std::shared_ptr<const PosedBody> body; // of the model in that immersion
};

// Each in its turn, as soon as it is there.
using DipLaid = std::function<void(std::size_t number, std::shared_ptr<const LaidFilm> laid)>;

// Simulates the dips in batches and lays their films. All cores; deterministic; `done` is called
// from the calling thread. Throws Error when the solver fails or a film does not follow the body,
// Cancelled.
void layDips(const DippedBody& body, const std::vector<ChangedDip>& dips,
             const solver::SolverModule& module, const Progress& progress, const DipLaid& done);

} // namespace dipwright

// Simulates many dips that deviate from the nominal one.
#pragma once

#include "accuracy/tolerance/Contributors.h"
#include "base/Progress.h"
#include "dip/LaidFilm.h"

#include <functional>
#include <memory>

namespace dipwright {

// The body and its nominal dip.
struct DippedBody {
    const TexturedMesh& model; // imported model, mm
    const Immersion& immersion;
    const ProcessSettings& process;
    std::shared_ptr<const PosedBody> body; // the model in the pose of `immersion`
};

// Receives each film in order, as soon as it is laid.
using DipLaid = std::function<void(std::size_t number, std::shared_ptr<const LaidFilm> laid)>;

// Simulates the dips in batches and lays their films. Uses all cores; deterministic. Calls `done`
// on the calling thread. Throws Error if the solver fails or a film does not follow the body, or
// Cancelled.
void layDips(const DippedBody& body, const std::vector<ChangedDip>& dips,
             const solver::SolverModule& module, const Progress& progress, const DipLaid& done);

} // namespace dipwright

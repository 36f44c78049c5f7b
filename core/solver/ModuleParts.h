// Exchanges named parts with a loaded module (interface/dipwright/SolverParts.h). Private to this
// folder.
#pragma once

#include <dipwright/SolverParts.h>

#include <memory>

namespace dipwright {

// Returns a part of this program; nullptr if it has no such part.
const void* programPart(const char* name, int version);

// Returns the module with the limits that it states: its films throw std::runtime_error with a
// sentence instead of beginning larger ones. Without limits returns the module itself.
std::shared_ptr<const solver::SolverModule>
limitedModule(std::shared_ptr<const solver::SolverModule> module, const solver::LimitsPart* limits);

} // namespace dipwright

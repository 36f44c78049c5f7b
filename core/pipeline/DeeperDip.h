// The film on a body that is dipped deeper than its job has it, to show what that does to the
// print.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// So much deeper, at most: what is asked for is an error at the tank and no other job.
inline constexpr Millimetres mostDeeper{10};

// Dips an immersion of the job again, with the film cells of its own dip, mostDeeper farther than
// its process says or as far as the body reaches. That must have a depth: all of a body cannot go
// deeper. Where a GPU solver fails, the best CPU solver takes over. Throws Error or Cancelled.
std::shared_ptr<const LaidFilm> dippedDeeper(const JobResult& result, std::size_t immersion,
                                             const SolverRegistry& registry,
                                             const Progress& progress);

} // namespace dipwright

// Which dips a film can be begun with.
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// Throws std::invalid_argument with a sentence unless the numbers of `setup` make a dip.
void requireValid(const solver::DipSetup& setup);

} // namespace dipwright::cuda

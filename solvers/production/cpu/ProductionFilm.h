// The production film on the CPU: isotropic, carried by the water and always in equilibrium.
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright::cpu {

// Simulates Lattice::Isotropic with Support::Water (docs/film-model.md, "The production model").
// The result is bit-identical for any number of threads.
std::unique_ptr<solver::FilmSolver> makeProductionFilm();

} // namespace dipwright::cpu

// The paper's film on the CPU: position-based distance constraints, a fixed number of sweeps a step
// (docs/film-model.md, "The paper's model").
#pragma once

#include <dipwright/FilmSolver.h>

#include <string>

namespace dipwright::cpu {

enum class Arithmetic { Vector, Scalar };

// Simulates Lattice::Structural on either support, and Lattice::Isotropic (distance constraints
// with diagonals of half stiffness) with Support::None. Throws std::invalid_argument for settings
// that make no dip. The same bits for any number of threads and either arithmetic.
std::unique_ptr<solver::FilmSolver> makePaperFilm(Arithmetic arithmetic = Arithmetic::Vector);

// What Arithmetic::Vector means on this processor: "AVX-512", "NEON" …
std::string paperFilmInstructionSet();

} // namespace dipwright::cpu

// Simulates the paper's film on the CPU: position-based distance constraints with a fixed number of
// sweeps per step (docs/film-model.md, "The paper's model").
#pragma once

#include <dipwright/FilmSolver.h>

#include <string>

namespace dipwright::cpu {

enum class Arithmetic { Vector, Scalar };

// Simulates Lattice::Structural on either support, and Lattice::Isotropic with Support::None
// (distance constraints with diagonals of half stiffness). Throws std::invalid_argument for invalid
// settings. The result is bit-identical for any number of threads and for both arithmetics.
std::unique_ptr<solver::FilmSolver> makePaperFilm(Arithmetic arithmetic = Arithmetic::Vector);

// Returns the instruction set of Arithmetic::Vector on this CPU: "AVX-512", "NEON" …
std::string paperFilmInstructionSet();

} // namespace dipwright::cpu

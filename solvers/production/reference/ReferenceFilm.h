// The production film, slow, in double precision and obviously right: the oracle for the others.
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright::reference {

// Simulates Lattice::Isotropic with Support::Water (docs/film-model.md, "The production model") to
// a residual of 1e-9. Meant for films of some thousand points.
std::unique_ptr<solver::FilmSolver> makeReferenceFilm();

} // namespace dipwright::reference

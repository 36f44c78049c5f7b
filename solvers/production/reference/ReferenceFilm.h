// The production film in double precision. It is slow; the other films are tested against it.
#pragma once

#include <dipwright/FilmSolver.h>

namespace dipwright::reference {

// Simulates Lattice::Isotropic with Support::Water (docs/film-model.md, "The production model") to
// a residual of 1e-9. Intended for films of up to some thousand points.
std::unique_ptr<solver::FilmSolver> makeReferenceFilm();

} // namespace dipwright::reference

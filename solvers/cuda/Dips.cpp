#include "cuda/Dips.h"

namespace dipwright::cuda {

bool areAlike(const solver::DipSetup& a, const solver::DipSetup& b) {
    const solver::FilmGrid &film = a.film, &other = b.film;
    const solver::Settings &s = a.settings, &t = b.settings;
    return film.columns == other.columns && film.rows == other.rows && film.width == other.width &&
           film.depth == other.depth && a.motion.speed == b.motion.speed &&
           a.field.spacing == b.field.spacing && s.lattice == t.lattice && s.support == t.support &&
           s.contactDistance == t.contactDistance && s.relaxationTime == t.relaxationTime &&
           s.timeStep == t.timeStep && s.iterations == t.iterations &&
           s.relaxation == t.relaxation && s.selfContact == t.selfContact &&
           s.contactTravel == t.contactTravel && s.residual == t.residual &&
           s.overhang == t.overhang;
}

} // namespace dipwright::cuda

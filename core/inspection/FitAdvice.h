// Why pairs do not tell a quantity, and what to photograph. Private to this folder.
#pragma once

#include "inspection/JointFit.h"

#include <QString>

namespace dipwright {

// Of a quantity that changes nothing of a film like the project's.
QString notInThisFilm(FitQuantity quantity);

// Of the unknown `unknown` in a solution, which is free: with which other one, or with the camera,
// it may be exchanged. `hasBodyPairs`: there are places of the body itself among the pairs.
QString whyUnknown(const JointSolution& solution, const std::vector<FitUnknown>& unknowns,
                   const std::vector<bool>& isFree, std::size_t unknown, const PlacesNear& near,
                   bool hasBodyPairs);

// Of relaxation that is found, but known to no better than a tenth of it; else empty.
QString whyUnsure(const JointSolution& solution, std::size_t unknown, const PlacesNear& near);

} // namespace dipwright

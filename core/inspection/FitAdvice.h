// Explains why pairs do not determine a quantity, and what to photograph. Private to this folder.
#pragma once

#include "inspection/JointFit.h"

#include <QString>

namespace dipwright {

// Explains that a quantity has no effect on the project's kind of film.
QString hasNoEffectSentence(FitQuantity quantity);

// Explains why the free unknown `unknown` is not determined, for example because another unknown or
// the camera has the same effect. `hasBodyPairs`: whether some pairs are places on the model, such
// as an edge, and not places of the print.
QString whyNotDetermined(const JointSolution& solution, const std::vector<FitUnknown>& unknowns,
                         const std::vector<bool>& isFree, std::size_t unknown,
                         const PlacesNear& near, bool hasBodyPairs);

// Explains how well relaxation is known; empty if it is known to within 10 %.
QString whyRelaxationIsUncertain(const JointSolution& solution, std::size_t unknown,
                                 const PlacesNear& near);

} // namespace dipwright

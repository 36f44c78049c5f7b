// Explains why pairs do not determine a quantity, and what to photograph. Private to this folder.
#pragma once

#include "inspection/JointFit.h"

#include <QString>

namespace dipwright {

// Explains that a quantity has no effect on a film like the project's.
QString hasNoEffectSentence(FitQuantity quantity);

// Explains why the free unknown `unknown` is not determined: which other unknown, or the camera,
// has the same effect. `hasBodyPairs` says whether some pairs are places on the body itself.
QString whyUnknown(const JointSolution& solution, const std::vector<FitUnknown>& unknowns,
                   const std::vector<bool>& isFree, std::size_t unknown, const PlacesNear& near,
                   bool hasBodyPairs);

// Explains how well relaxation is known if it is known to no better than a tenth; otherwise empty.
QString whyRelaxationIsUncertain(const JointSolution& solution, std::size_t unknown,
                                 const PlacesNear& near);

} // namespace dipwright

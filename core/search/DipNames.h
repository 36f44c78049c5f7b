// Names the dips of a found pose or pair of poses.
#pragma once

#include "settings/Immersion.h"

#include <vector>

namespace dipwright {

// Names `found` after `own`, the project's dips, so that a name stays with the side of the part
// that is dipped, not with the number of the dip. A dip takes the name of the own dip that lowers
// nearly the same side: the angle between the two directions that point down is below 90°. Of two
// dips, each takes another name, in the order in which the directions agree best. A dip without
// such a name is called "Dip N", as are all dips if the numbers of dips differ; names of this form
// stay with their numbers.
void nameDips(std::vector<Immersion>& found, const std::vector<Immersion>& own);

} // namespace dipwright

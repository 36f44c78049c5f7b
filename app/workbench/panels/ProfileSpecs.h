// How every value of a profile is called and explained.
#pragma once

#include "panels/PropertySpecs.h"
#include "settings/Profile.h"

namespace dipwright {

// All values but a printer's ICC profile, which is a file to choose.
std::vector<PropertySection> profileSections(ProfileKind kind);

} // namespace dipwright

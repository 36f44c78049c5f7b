// How every value of a profile is called and explained.
#pragma once

#include "settings/Profile.h"
#include "workbench/project/PropertySpecs.h"

namespace dipwright {

// All values but a printer's ICC profile, which is a file to choose.
std::vector<PropertySection> profileSections(ProfileKind kind);

} // namespace dipwright

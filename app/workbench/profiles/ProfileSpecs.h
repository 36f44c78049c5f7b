// Labels and explains every value of a profile.
#pragma once

#include "settings/Profile.h"
#include "workbench/project/PropertySpecs.h"

namespace dipwright {

// All values except a printer's ICC profile, which is a file.
std::vector<PropertySection> profileSections(ProfileKind kind);

} // namespace dipwright

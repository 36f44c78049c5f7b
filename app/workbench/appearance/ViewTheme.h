// The colours of the 3D view in both themes.
#pragma once

#include "viewport/DipView.h"

namespace dipwright {

ViewColours viewColours(bool dark);

} // namespace dipwright

// A body that wears its zones, and how much of their limits is used up.
#pragma once

#include "workbench/appearance/BodyAppearance.h"

namespace dipwright {

// A zone has a colour, pale where little of its limit is used up. Without tolerances (null) it is
// even. `zones` has the marks of `settings`; `body` is plainBody() of its mesh.
BodyAppearance zoneAppearance(std::shared_ptr<const TexturedMesh> body, const ZonedBody& zones,
                              const JobTolerances* tolerances, const ToleranceSettings& settings);

} // namespace dipwright

// Colours a body by its zones and by how much of each zone's limit is used up.
#pragma once

#include "workbench/appearance/BodyAppearance.h"

namespace dipwright {

// Each zone has a colour, which is pale where little of the limit is used up, and even without
// `tolerances` (null). `zones` must come from the marks in `settings`, and `body` must be
// plainBody() of its mesh.
BodyAppearance zoneAppearance(std::shared_ptr<const TexturedMesh> body, const ZonedBody& zones,
                              const JobTolerances* tolerances, const ToleranceSettings& settings);

} // namespace dipwright

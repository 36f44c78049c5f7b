// Colours a body by its zones and by how much of each zone's limit is used up.
#pragma once

#include "workbench/appearance/BodyAppearance.h"

namespace dipwright {

QColor zoneColour(Zone zone);

// Each zone has its own colour. The colour is pale where the image uses up little of the zone's
// limit. If `tolerances` is null, the whole zone has one shade. `zones` must come from the marks in
// `settings`, and `body` must be plainBody() of its mesh.
BodyAppearance zoneAppearance(std::shared_ptr<const TexturedMesh> body, const ZonedBody& zones,
                              const JobTolerances* tolerances, const ToleranceSettings& settings);

} // namespace dipwright

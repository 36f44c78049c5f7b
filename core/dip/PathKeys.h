// Turns any path into poses that the user can edit (PathKind::Poses).
#pragma once

#include "geometry/TriangleMesh.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"

#include <vector>

namespace dipwright {

// Returns the path of `immersion` as poses at equal times, with rounded values: two for a part that
// goes straight down, otherwise at least five, with turns of at most 60° between them. They follow
// the path nearly; between them the part moves smoothly. `posed` is the part in its pose frame
// (Pose.h). Throws Error if the path cannot be travelled.
DipPath asPoses(const TriangleMesh& posed, const Immersion& immersion,
                const ProcessSettings& process);

// Returns when the part takes each pose, s. This is the pose's time, or later if the acceleration
// is limited. The path must go through poses. Throws Error if it cannot be travelled.
std::vector<double> timesOfKeys(const TriangleMesh& posed, const Immersion& immersion,
                                const ProcessSettings& process);

// Returns a pose halfway between two poses, in time and in every value. `depth` is the depth of the
// dip.
PathKey middleKey(const PathKey& before, const PathKey& after, Millimetres depth);

} // namespace dipwright

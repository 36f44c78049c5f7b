// Several models on one jig, dipped at once through one film: one body to all that follows, in
// which each keeps its own texture and place.
#pragma once

#include "dip/Pose.h"
#include "model/TexturedMesh.h"
#include "settings/Immersion.h"

#include <memory>
#include <vector>

namespace dipwright {

struct JigPart {
    std::shared_ptr<const TexturedMesh> model;
    Immersion placed; // its name, how it is turned, and where its middle hangs on the jig, x and z
    Millimetres height{0}; // of its lowest point over that of the lowest of all
};

// Materials are called "PART: MATERIAL". Throws Error: no part, more materials than a model may
// have, parts whose boxes overlap (two bodies in one place have no surface to be printed on).
TexturedMesh jigModel(const std::vector<JigPart>& parts);

} // namespace dipwright

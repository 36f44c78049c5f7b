// Combines several models on one jig into one body, to dip them together through one film. Each
// model keeps its own texture and position.
#pragma once

#include "dip/Pose.h"
#include "model/TexturedMesh.h"
#include "settings/Immersion.h"

#include <memory>
#include <vector>

namespace dipwright {

struct JigPart {
    std::shared_ptr<const TexturedMesh> model;
    // Name and rotation of the part, and the position of its middle on the jig (x and z).
    Immersion placed;
    Millimetres height{0}; // height of its lowest point above the lowest point of all parts
};

// Numbers parts that have the same name: "Knob", "Knob 2". No part gets the name of another part.
void numberEqualNames(std::vector<JigPart>& parts);

// Returns all parts as one model, with materials named "PART: MATERIAL"; numbers equal names of
// parts. Throws Error if there is no part, if there are more materials than a model may have, or if
// the bounding boxes of parts overlap.
TexturedMesh jigModel(std::vector<JigPart> parts);

} // namespace dipwright

// The separate bodies of a model, such as the parts on a jig.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>
#include <memory>

namespace dipwright {

struct SeparateBodies {
    std::vector<std::uint32_t> ofTriangle; // for each triangle the index of its body
    QStringList names;                     // of the bodies, for the user
};

// A model with more pieces of its surface counts as one body.
inline constexpr std::size_t mostSeparatePieces = 1000;

// Finds the bodies of a model; null if it has only one. Connected pieces of the surface belong to
// one body if their bounding boxes overlap. The boxes of two parts on a jig never do (JigModel.h).
// A body has the name of its part on the jig or of its only material, or else its place in mm.
// Deterministic; takes milliseconds.
std::shared_ptr<const SeparateBodies> separateBodies(const TexturedMesh& model);

} // namespace dipwright

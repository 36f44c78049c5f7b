// Hashes a model's contents, so that work on equal models is recognised. Both functions remember
// the hash of their last model, take a model that is not null, and may be called by any thread.
#pragma once

#include <QString>
#include <memory>

namespace dipwright {

struct TexturedMesh;

// Returns the SHA-256 of the model's triangles, hexadecimal.
QString meshHash(const std::shared_ptr<const TexturedMesh>& model);

// Returns the SHA-256 of the triangles and their appearance: texture coordinates, materials, the
// pixels of the textures and their amounts of ink. Hexadecimal.
QString modelHash(const std::shared_ptr<const TexturedMesh>& model);

} // namespace dipwright

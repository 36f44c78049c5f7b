// Finds surface by the name of its material. Each face of a CAD model has a material of its own, so
// that faces are found by their names, too.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>
#include <optional>

namespace dipwright {

// Returns the indices of the materials with this name; none if the model has no such material.
std::vector<std::size_t> materialsNamed(const SurfaceAppearance& model, const QString& name);

// Returns all names, each once, in the order of the materials. Leaves out empty names, and names
// that are too long for the project file (longestMaterialName).
QStringList materialNames(const SurfaceAppearance& model);

// Returns the place on the surface with this name that is nearest to the surface's centre of area.
// Nothing if there is no such surface.
std::optional<Eigen::Vector3f> middleOfMaterial(const TexturedMesh& model, const QString& name);

} // namespace dipwright

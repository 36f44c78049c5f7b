// Reads and writes the model file inside a project.
#pragma once

#include "model/TexturedMesh.h"

#include <QByteArray>

namespace dipwright {

// A model as it is stored, with encoded pictures.
struct StoredModel {
    TexturedMesh model;               // without textures; its materials refer to them by index
    std::vector<QByteArray> pictures; // PNG files, not validated
};

// Returns the model with each picture replaced by a single pixel, because the pictures are stored
// elsewhere.
TexturedMesh withoutPictures(const TexturedMesh& model);

// Returns the model as one self-contained file for a project's assets. Lossless: float positions,
// texture coordinates, charts and pictures.
QByteArray writeModel(const TexturedMesh& model);

// Reads the model from `bytes`. Throws Error about `where` if it is damaged, has a newer format, or
// exceeds the limits of Budgets.h.
StoredModel readModel(const QByteArray& bytes, const QString& where);

// Reads a model without checking its contents: it may be empty, and its coordinates may not be
// finite.
StoredModel readUncheckedModel(const QByteArray& bytes, const QString& where);

} // namespace dipwright

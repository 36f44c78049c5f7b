// The project's own model file.
#pragma once

#include "model/TexturedMesh.h"

#include <QByteArray>

namespace dipwright {

// A model as it was stored, with its pictures still packed.
struct StoredModel {
    TexturedMesh model;               // without textures; its materials name them by index
    std::vector<QByteArray> pictures; // PNG of each of them, not looked at
};

// The model without its pictures, which then stand elsewhere: one pixel holds each one's place.
TexturedMesh withoutPictures(const TexturedMesh& model);

// The model as one self-contained file for a project's assets, lossless in positions to float,
// texture coordinates, charts and pictures.
QByteArray writeModel(const TexturedMesh& model);

// The model that `bytes` hold. Throws Error about `where` for what is damaged, newer, or more than
// Budgets.h allows.
StoredModel readModel(const QByteArray& bytes, const QString& where);

// The same for a model that was read and not yet looked at: it may be empty and its coordinates no
// numbers.
StoredModel readUncheckedModel(const QByteArray& bytes, const QString& where);

} // namespace dipwright

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

// The model as one self-contained file for a project's assets, lossless in positions to float,
// texture coordinates, charts and pictures.
QByteArray writeModel(const TexturedMesh& model);

// The model that `bytes` hold. Throws Error about `where` for what is damaged, newer, or more than
// Budgets.h allows.
StoredModel readModel(const QByteArray& bytes, const QString& where);

} // namespace dipwright

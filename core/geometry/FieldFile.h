// The file format of cached distance fields. These files never leave this computer.
#pragma once

#include "geometry/DistanceField.h"

#include <QIODevice>
#include <memory>

namespace dipwright {

// Increased when the result of buildDistanceField, its storage, or the grids of the cached fields
// change.
inline constexpr quint32 fieldFileVersion = 2;

// Returns false if the device cannot take all bytes.
bool writeField(const DistanceField& field, QIODevice& device);
// Returns null unless the device holds a complete field with at most mostFieldBytes of samples.
std::shared_ptr<DistanceField> readField(QIODevice& device);
inline constexpr qint64 mostFieldBytes = qint64(512) << 20;

} // namespace dipwright

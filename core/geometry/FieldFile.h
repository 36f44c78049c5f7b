// A distance field as the cache keeps it in a file, which never leaves this computer.
#pragma once

#include "geometry/DistanceField.h"

#include <QIODevice>
#include <memory>

namespace dipwright {

// Raised when what buildDistanceField computes, or how it is stored, changes.
inline constexpr quint32 fieldFileVersion = 1;

// False where the device does not take all of it.
bool writeField(const DistanceField& field, QIODevice& device);
// A field of `resolution` samples along each axis. Null where the device holds anything else, of
// which no more is read than such a field has.
std::shared_ptr<const DistanceField> readField(QIODevice& device, int resolution);

} // namespace dipwright

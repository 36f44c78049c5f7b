// A distance field as the cache keeps it in a file, which never leaves this computer.
#pragma once

#include "geometry/DistanceField.h"

#include <QIODevice>
#include <memory>

namespace dipwright {

// Raised when what buildDistanceField computes, or how it is stored, changes.
inline constexpr quint32 fieldFileVersion = 2;

// False where the device does not take all of it.
bool writeField(const DistanceField& field, QIODevice& device);
// Null where the device holds anything but a whole field of at most mostFieldBytes of samples.
std::shared_ptr<const DistanceField> readField(QIODevice& device);
inline constexpr qint64 mostFieldBytes = qint64(512) << 20;

} // namespace dipwright

// How the body is held over the film in one dip, as in the project file's "immersions". dip/Pose.h
// applies it to a body.
#pragma once

#include "base/Units.h"
#include "settings/DipPath.h"
#include "settings/UnknownKeys.h"

#include <QString>
#include <array>

namespace dipwright {

struct Immersion {
    QString name = QStringLiteral("Immersion");
    // Angles about X, Y, Z, applied in that order; on a path, at the end of the dip.
    std::array<Degrees, 3> rotation{};
    // Offset of the body from the film's centre along X and Z; on a path, when the dip begins.
    std::array<Millimetres, 2> offset{};
    DipPath path = {};
    UnknownKeys unknown = {};
    bool operator==(const Immersion&) const = default;
};

} // namespace dipwright

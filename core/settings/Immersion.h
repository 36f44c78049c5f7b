// How the body is held over the film in one dip, as in the project file's "immersions". dip/Pose.h
// applies it to a body.
#pragma once

#include "base/Units.h"

#include <QString>
#include <array>

namespace dipwright {

struct Immersion {
    QString name = QStringLiteral("Immersion");
    std::array<Degrees, 3> rotation{};   // about X, Y, Z, applied in that order
    std::array<Millimetres, 2> offset{}; // of the body in the plane of the water, X and Z
    bool operator==(const Immersion&) const = default;
};

} // namespace dipwright

// The step by which a menu item or a key turns or moves the body.
#pragma once

#include <QMetaType>

namespace dipwright {

// Stored in an action's data. `axis`: 0, 1, 2 for X, Y, Z of the world frame; X and Z lie along the
// film. `way`: +1 or −1 is one step of the view's handles; 0 moves the body to the film's centre.
struct BodyStep {
    int axis = 0, way = 0;
};

} // namespace dipwright

Q_DECLARE_METATYPE(dipwright::BodyStep)

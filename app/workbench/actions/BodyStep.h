// A step by which a menu or a key turns or moves the body.
#pragma once

#include <QMetaType>

namespace dipwright {

// In an action's data: an axis of the world, and which way, as +1 or −1 step of the view's handles;
// of moves 0 as way is to the film's middle. X and Z are along the film.
struct BodyStep {
    int axis = 0, way = 0;
};

} // namespace dipwright

Q_DECLARE_METATYPE(dipwright::BodyStep)

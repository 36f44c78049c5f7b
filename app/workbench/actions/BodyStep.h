// The step by which a menu item or a key turns or moves the body.
#pragma once

#include <QMetaType>

namespace dipwright {

// An action stores its step in its data. `axis` is 0, 1 or 2 for X, Y or Z of the world frame; X
// and Z lie along the film. `way` is the direction, +1 or −1: the body turns or moves by one step
// of the view's handles. 0 moves it to the film's centre.
struct BodyStep {
    int axis = 0, way = 0;
};

} // namespace dipwright

Q_DECLARE_METATYPE(dipwright::BodyStep)

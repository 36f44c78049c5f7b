// Continuing the printed colour outwards, so that a dip a little off shows no bare edge.
#pragma once

#include <QImage>

namespace dipwright {

// Gives every pixel with alpha 0 that lies within `radius` pixels of one with alpha 255 the colour
// of the nearest such pixel (exact Euclidean distances). `image` has Format_RGBA8888 or is wide.
// All cores.
void continueColour(QImage& image, double radius);

} // namespace dipwright

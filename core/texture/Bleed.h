// Continues the printed colour outwards, so that a small misplacement of the dip shows no bare
// edge.
#pragma once

#include <QImage>

namespace dipwright {

// Gives each pixel with alpha 0 the colour of the nearest pixel with alpha 255 that lies within
// `radius` pixels (exact Euclidean distances). `image` has Format_RGBA8888 or is wide. Uses all
// cores.
void continueColour(QImage& image, double radius);

} // namespace dipwright

// Draws the colours of a surface into a picture for its charts.
#pragma once

#include "artwork/Unwrap.h"

#include <QImage>
#include <functional>

namespace dipwright {

// Returns a picture whose sides are powers of two, at most `most` pixels, in which the charts of
// `charts` fill the whole area. `colour` returns the colour at a place of the unwrapped mesh; it is
// called from several threads. Space between the charts gets the colours beside it, so that no seam
// shows when the picture is reduced or compressed. Throws Cancelled.
QImage paintedTexture(const Unwrapping& charts, int most,
                      const std::function<QRgb(const SurfacePoint&)>& colour,
                      const CancelToken& cancelToken);

} // namespace dipwright

// How out-of-gamut colours are handled (ICC.1, rendering intents).
#pragma once

namespace dipwright {

enum class RenderingIntent { Perceptual, RelativeColorimetric, Saturation, AbsoluteColorimetric };

} // namespace dipwright

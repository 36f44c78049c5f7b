// How colours that the printer cannot make are dealt with (ICC.1, rendering intents).
#pragma once

namespace dipwright {

enum class RenderingIntent { Perceptual, RelativeColorimetric, Saturation, AbsoluteColorimetric };

} // namespace dipwright

// How pictures are converted to a printer's inks.
#pragma once

namespace dipwright {

// How out-of-gamut colours are handled (ICC.1, rendering intents).
enum class RenderingIntent { Perceptual, RelativeColorimetric, Saturation, AbsoluteColorimetric };

// What a CMYK printer prints in one ink alone instead of in a mixture of inks of the same colour.
// Pictures in CMYK have amounts of ink only if their files had an ICC profile.
enum class KeptInks {
    None,
    Black, // greys of RGB pictures; amounts of black alone in CMYK pictures, which stay as they are
    Pure   // the same, and amounts of cyan, magenta or yellow alone
};

} // namespace dipwright

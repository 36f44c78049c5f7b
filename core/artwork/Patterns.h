// Generates repeating patterns. Private to this folder.
#pragma once

#include "settings/Artwork.h"

namespace dipwright {

// Returns one square repeat of a pattern layer, `pixels` wide, in sRGB (RGBA8888). Its right edge
// continues in its left edge, and its lower edge in its upper edge. The result depends only on the
// layer's kind, colours and seed, and is the same in every run.
QImage patternRepeat(const ArtworkLayer& layer, int pixels);

} // namespace dipwright

// Repeating patterns of our own making. Private to this folder.
#pragma once

#include "settings/Artwork.h"

namespace dipwright {

// One repeat of a pattern layer, square, of so many pixels a side, sRGB (RGBA8888). Its right edge
// continues in its left one and its lower in its upper one. Of its kind, colours and seed alone;
// the same in every run.
QImage patternRepeat(const ArtworkLayer& layer, int pixels);

} // namespace dipwright

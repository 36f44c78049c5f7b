// The ways in which the 3D view can show film and body.
#pragma once

namespace dipwright {

enum class FilmLook { Lines, Sheet, Chessboard, Picture, Stretch, Shares };
enum class FilmExtent { Whole, OnBody };
// Own: the model's texture. Coverage: painted, bare and marked areas, or the shares of two dips.
// Print: the finished part. Zones: the zones of the body. Difference: where two dips differ. All
// looks except Own hide the film at the end of the dip.
enum class BodyLook { Own, Coverage, Print, Zones, Difference };

} // namespace dipwright

// What film and body can look like in the 3D view.
#pragma once

namespace dipwright {

enum class FilmLook { Lines, Sheet, Chessboard, Picture, Stretch, Shares };
enum class FilmExtent { Whole, OnBody };
// The model's texture; painted, bare and marked parts, or the dips' shares; what comes out of the
// dips; the zones of the body. All but the first hide the film at the end of the dip.
enum class BodyLook { Own, Coverage, Print, Zones };

} // namespace dipwright

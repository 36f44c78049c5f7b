// Masks: surface that must stay free of film. It is covered with tape before the dip.
#pragma once

#include "settings/SurfaceMark.h"

namespace dipwright {

// Masks an area, or takes an area out of earlier masks. Its extent is a face, a material or a
// stroke.
struct MaskMark : SurfaceMark {
    MaskMark() { extent = MarkExtent::Stroke; }
    bool erases = false;
    bool operator==(const MaskMark&) const = default;
};

inline constexpr std::size_t mostMaskMarks = 1000;
inline constexpr double leastMaskRadius = 0.1; // mm, of a stroke

} // namespace dipwright

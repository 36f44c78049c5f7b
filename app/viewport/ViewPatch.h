// A coloured part of the body's surface in the 3D view.
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <array>
#include <vector>

namespace dipwright {

struct ViewPatch {
    std::vector<std::array<Eigen::Vector3f, 3>> triangles; // model coordinates, mm
    QColor colour;                                         // its alpha is the opacity
};

// Patches that are drawn over the body. Later ones lie over earlier ones.
enum class PatchLayer { Masks, Stroke };
inline constexpr std::size_t patchLayers = 2;

} // namespace dipwright

// How much of the body's colour one of two films gives each place.
#pragma once

#include "geometry/RefinedMesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

// One film's side of a join between two. In a band along the join the densities of both fade
// linearly into each other, D·w and D·(1 − w), so that together they are D, whatever the colour;
// past it one film gives all and the other nothing. Any thread may read.
struct PaintShare {
    // How far a place is from the join, in widths of the band there, which may be wider in one
    // place than in another; above 0 on the first film's side.
    SurfaceField fade;
    bool isFirst = true; // whose share this is
    float narrowest = 0; // mm: the band where it may be as narrow as that, above 0

    // w, of the density at a place of the body: 0 nothing … 1 all of it.
    float at(const SurfacePoint& point) const {
        const float inside = isFirst ? fade.at(point) : -fade.at(point);
        return std::clamp(0.5f + inside, 0.0f, 1.0f);
    }
    // The share of all places within `reach` mm of one, where it is the same: 0 or 1.
    std::optional<float> allWithin(float reach, const SurfacePoint& point) const {
        const float inside = isFirst ? fade.at(point) : -fade.at(point);
        if (std::abs(inside) < 0.5f + reach / narrowest) {
            return std::nullopt;
        }
        return inside > 0 ? 1.0f : 0.0f;
    }
};

} // namespace dipwright

// How much of the body's colour one of two films gives each place.
#pragma once

#include "geometry/RefinedMesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

// One film's side of a join between two. In a band of `overlap` along the join the densities of
// both fade linearly into each other, D·w and D·(1 − w), so that together they are D, whatever the
// colour; past it one film gives all and the other nothing. Any thread may read.
struct PaintShare {
    SurfaceField distance; // mm from the join along the body, above 0 on the first film's side
    bool isFirst = true;   // whose share this is
    float overlap = 0;     // mm

    // w, of the density at a place of the body: 0 nothing … 1 all of it.
    float at(const SurfacePoint& point) const {
        const float inside = isFirst ? distance.at(point) : -distance.at(point);
        return overlap > 0 ? std::clamp(0.5f + inside / overlap, 0.0f, 1.0f) : float(inside >= 0);
    }
    // The share of all places within `reach` mm of one, where it is the same: 0 or 1.
    std::optional<float> allWithin(float reach, const SurfacePoint& point) const {
        const float inside = isFirst ? distance.at(point) : -distance.at(point);
        if (std::abs(inside) < overlap / 2 + reach) {
            return std::nullopt;
        }
        return inside > 0 ? 1.0f : 0.0f;
    }
};

} // namespace dipwright

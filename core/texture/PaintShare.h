// Tells how much of the colour one of two films contributes at each place of the body.
#pragma once

#include "geometry/RefinedMesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

// One film's share of a body that two films paint. In the overlap along the seam, the films print
// the densities D·w and D·(1 − w), whose sum is D for any colour. The share w changes linearly
// across the overlap. Outside the overlap one film gives the whole density and the other none. Any
// thread may read.
struct PaintShare {
    // Distance of a place from the seam, as a multiple of the overlap's width at that place.
    // Positive on the first film's side.
    SurfaceField fade;
    bool isFirst = true; // whether this is the first film's share
    float narrowest = 0; // least width of the overlap, above 0 mm

    // Returns w, this film's share of the density at a place of the body, 0 … 1.
    float at(const SurfacePoint& point) const {
        const float inside = isFirst ? fade.at(point) : -fade.at(point);
        return std::clamp(0.5f + inside, 0.0f, 1.0f);
    }
    // Returns 0 or 1 if all places within `reach` mm of `point` have this share; none if the share
    // may vary.
    std::optional<float> allWithin(float reach, const SurfacePoint& point) const {
        const float inside = isFirst ? fade.at(point) : -fade.at(point);
        if (std::abs(inside) < 0.5f + reach / narrowest) {
            return std::nullopt;
        }
        return inside > 0 ? 1.0f : 0.0f;
    }
};

} // namespace dipwright

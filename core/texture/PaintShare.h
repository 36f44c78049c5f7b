// Tells how much of the body's colour one of two films gives each place.
#pragma once

#include "geometry/RefinedMesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

// One film's share of a body that two films paint. In the overlap along the seam, the densities of
// both films fade linearly into each other. They are D·w and D·(1 − w), so that their sum is D for
// any colour. Outside the overlap one film gives all and the other nothing. Any thread may read.
struct PaintShare {
    // Distance of a place from the seam, in widths of the overlap there, which may vary along the
    // seam. Positive on the first film's side.
    SurfaceField fade;
    bool isFirst = true; // whether this is the first film's share
    float narrowest = 0; // mm: the overlap's least width, above 0

    // Returns w, the share of the density at a place of the body: 0 nothing … 1 all of it.
    float at(const SurfacePoint& point) const {
        const float inside = isFirst ? fade.at(point) : -fade.at(point);
        return std::clamp(0.5f + inside, 0.0f, 1.0f);
    }
    // Returns the common share, 0 or 1, of all places within `reach` mm of `point`; none if it may
    // vary.
    std::optional<float> allWithin(float reach, const SurfacePoint& point) const {
        const float inside = isFirst ? fade.at(point) : -fade.at(point);
        if (std::abs(inside) < 0.5f + reach / narrowest) {
            return std::nullopt;
        }
        return inside > 0 ? 1.0f : 0.0f;
    }
};

} // namespace dipwright

// How well one dip can paint each place of the body.
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"
#include "settings/InkSettings.h"
#include "texture/LinearLight.h"

namespace dipwright {

// A fine triangle each.
struct Suitability {
    std::vector<std::uint8_t> reached; // 1 where the dip paints its middle
    std::vector<float> stretch;        // the larger one of its film there; 1 where it is not
    std::vector<float> cost;           // of painting it with this dip, for each mm²; 0: perfectly
};

// By whether the dip paints the place, whether the film there tore, was let go of or found no rest,
// how far it is stretched, whether its ink suffices, and how steeply the body meets the water.
// `colours`: what each fine triangle is to show. All cores.
Suitability suitability(const RefinedMesh& body, const LaidFilm& laid,
                        const std::vector<LinearColour>& colours, double stretchLimit,
                        const InkSettings& ink);

} // namespace dipwright

// Rates how well one dip can paint each place of the body.
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"
#include "settings/InkSettings.h"
#include "texture/LinearLight.h"

namespace dipwright {

// All arrays have one value per triangle of the RefinedMesh (the fine triangles).
struct Suitability {
    std::vector<std::uint8_t> reached; // 1 if the dip paints its middle
    // Larger principal stretch of the film there; 1 where there is no film.
    std::vector<float> stretch;
    std::vector<float> cost; // cost of painting 1 mm² of the triangle with this dip; 0 is ideal
};

// Rates one dip. The cost of a triangle depends on whether the dip paints it and whether the film
// there is marked. It also depends on the stretch of that film, on its ink, and on how steeply the
// body meets the water. `colours` are the colours that the fine triangles are to show. Uses all
// cores.
Suitability suitability(const RefinedMesh& body, const LaidFilm& laid,
                        const std::vector<LinearColour>& colours, double stretchLimit,
                        const InkSettings& ink);

} // namespace dipwright

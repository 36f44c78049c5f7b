// Computes how wide the overlap of two fading films must be to hide a misregistration of the second
// film (docs/film-model.md, "Two dips, one body").
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/SurfaceDistance.h"
#include "share/BodyShare.h"
#include "texture/LinearLight.h"

namespace dipwright {

// Returns the overlap width in mm of flat film, at least `least`. With this width, a film that lies
// `error` mm off shows no step of more than 0.1 of full reflectance. `colour` is the reflectance
// that the body is to show.
double neededOverlap(const LinearColour& colour, double error, double least);

// The overlap width at each place of a body. A displacement on the water is equally large on the
// flat film, so the width is measured there.
class FadeOverlap {
public:
    // `colours` are the colours that the fine triangles are to show. `body` must outlive this
    // object. Uses all cores.
    FadeOverlap(const RefinedMesh& body, const LaidFilm& second,
                const std::vector<LinearColour>& colours, const ShareSettings& settings);

    // Returns the fine triangles as they lie on the flat second film; on the body where that film
    // does not reach. The unit is the overlap width that is needed there.
    const UnfoldedTriangles& measure() const { return measure_; }
    // Smallest overlap width on the body, mm.
    float narrowest() const { return narrowest_; }
    // Returns the share of the area that both dips paint in which the fade is so steep that the
    // second film shows. `fade` is per position, in overlap widths.
    double tooNarrow(const std::vector<float>& fade, const std::vector<Painter>& painters) const;

private:
    const RefinedMesh& body_;
    float narrowest_;
    // Corners on the flat film, mm.
    std::vector<std::optional<std::array<Eigen::Vector3f, 3>>> flat_;
    std::vector<float> needed_; // mm of flat film, for each triangle's own colour
    UnfoldedTriangles measure_;
};

} // namespace dipwright

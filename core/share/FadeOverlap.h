// Computes how wide the overlap of two fading films must be to hide a misregistration of the second
// film (docs/film-model.md, "Two dips, one body").
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/SurfaceDistance.h"
#include "share/BodyShare.h"
#include "texture/LinearLight.h"

namespace dipwright {

// Returns the overlap width in mm of flat film, at least `least`. With this width, a displacement
// of the film by `error` mm changes the reflectance by at most 0.1. `colour` is the reflectance
// that the body is to show.
double neededOverlap(const LinearColour& colour, double error, double least);

// The overlap width at each place of a body. A displacement on the water is equally large on the
// flat film, so the width is measured on the flat film.
class FadeOverlap {
public:
    // `colours` are the colours that the fine triangles are to show. `body` must outlive this
    // object. Uses all cores.
    FadeOverlap(const RefinedMesh& body, const LaidFilm& second,
                const std::vector<LinearColour>& colours, const ShareSettings& settings);

    // Returns the fine triangles as they lie on the flat second film or, where that film does not
    // reach, on the body. Lengths are in overlap widths that are needed there.
    const UnfoldedTriangles& measure() const { return measure_; }
    // Smallest overlap width on the body, mm.
    float narrowest() const { return narrowest_; }
    // Returns the share of the area painted by both dips in which the fade is too steep. There, a
    // displaced second film shows. `fade` is per position, in overlap widths.
    double tooNarrow(const std::vector<float>& fade, const std::vector<Painter>& painters) const;

private:
    const RefinedMesh& body_;
    float narrowest_;
    // Per fine triangle: its corners on the flat film, mm.
    std::vector<std::optional<std::array<Eigen::Vector3f, 3>>> flat_;
    // Per fine triangle: overlap width for its own colour, mm of flat film.
    std::vector<float> needed_;
    UnfoldedTriangles measure_;
};

} // namespace dipwright

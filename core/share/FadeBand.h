// How wide the band has to be in which two films fade into each other so that it does not show when
// the second of them lies off (docs/film-model.md, "Two dips, one body").
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/SurfaceDistance.h"
#include "share/BodyShare.h"
#include "texture/LinearLight.h"

namespace dipwright {

// The width of the band, mm of flat film, in which two fading films show no edge of more than a
// tenth of full reflectance though one lies `error` mm off, where the body is to show this
// reflectance; no less than `least`.
double neededOverlap(const LinearColour& colour, double error, double least);

// The band on a body, place by place. What lies off on the water is off on the flat film by as
// much, so there the band is measured.
class FadeBand {
public:
    // `colours`: what each fine triangle is to show. All of them outlive this. All cores.
    FadeBand(const RefinedMesh& body, const LaidFilm& second,
             const std::vector<LinearColour>& colours, const ShareSettings& settings);

    // The fine triangles as they lie on the second film where it is flat, or on the body where it
    // does not reach, in widths of the band that is needed there.
    const UnfoldedTriangles& measure() const { return measure_; }
    // mm on the body that a band has at least.
    float narrowest() const { return narrowest_; }
    // The share of what both paint in which a fade, a number of bands a position, is so steep that
    // the second film shows.
    double tooNarrow(const std::vector<float>& fade, const std::vector<Painter>& painters) const;

private:
    const RefinedMesh& body_;
    float narrowest_;
    std::vector<std::optional<std::array<Eigen::Vector3f, 3>>> flat_; // corners, mm of flat film
    std::vector<float> needed_; // mm of flat film, by each triangle's own colour
    UnfoldedTriangles measure_;
};

} // namespace dipwright

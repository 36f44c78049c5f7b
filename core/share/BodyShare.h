// The body shared out between two dips: which of them paints which place, and the join between
// (docs/film-model.md, "Two dips, one body").
#pragma once

#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"
#include "model/TexturedMesh.h"
#include "settings/InkSettings.h"
#include "settings/ShareSettings.h"
#include "texture/PaintShare.h"

namespace dipwright {

// Who paints how much of the body, mm².
struct ShareAreas {
    double first = 0, second = 0; // by one dip alone
    double both = 0;              // in the band along the join
    double none = 0;              // by neither: no film reaches it
    double total() const { return first + second + both + none; }
    bool operator==(const ShareAreas&) const = default;
};

enum class Painter : std::uint8_t { None, First, Second, Both };

// The width of the band where both dips fade, mm, along the join.
struct OverlapWidth {
    double least = 0, middle = 0, most = 0; // of 5, 50 and 95 % of the join at most
};

// A piece of the body that neither dip reaches.
struct UnpaintedPlace {
    double area = 0;                                 // mm²
    Eigen::Vector3f place = Eigen::Vector3f::Zero(); // in the middle of it, model coordinates, mm
};

// How much a line on the body will be seen: the integral along it of the contrast of the texture
// times the visibility of the place, each from a tenth to about 1.
struct JoinCost {
    double length = 0; // mm
    double cost = 0;   // mm
};

// Immutable; any thread may read.
struct BodyShare {
    SurfaceField fade;                                // as PaintShare has it
    float narrowest = 0;                              // likewise
    std::vector<Painter> painters;                    // a fine triangle each
    std::vector<std::array<Eigen::Vector3f, 2>> join; // the line, in pieces; model coordinates, mm
    OverlapWidth overlap;
    // The share of the overlap that is too narrow: there the second film shows by more than a tenth
    // of full reflectance if it lies as far off as it may.
    double narrow = 0;
    ShareAreas areas;
    // How far each dip's film is drawn out along the join, but for the quarter of it that is drawn
    // out most: what lies off on the water is so many times as far off on the body.
    std::array<double, 2> joinStretch{1, 1};
    JoinCost cost;    // of the join …
    JoinCost equator; // … and of the plane halfway between the two poses, moved as far as it takes
                      // that all is painted that a dip reaches
    std::vector<UnpaintedPlace> unpainted; // the largest first

    // What dip `number`, 0 or 1, is to paint.
    PaintShare of(std::size_t number) const { return {fade, number == 0, narrowest}; }
};

// `films`: the two dips of `model`. Deterministic, all cores; throws Cancelled.
BodyShare shareBody(const TexturedMesh& model,
                    const std::array<std::shared_ptr<const LaidFilm>, 2>& films,
                    const ShareSettings& settings, const InkSettings& ink,
                    const Progress& progress);

// The dip, 0 or 1, that is better made last, for it is the last film that lies off: the one whose
// film is drawn out less along the join, if that makes a difference.
std::optional<std::size_t> betterLast(const BodyShare& share);

} // namespace dipwright

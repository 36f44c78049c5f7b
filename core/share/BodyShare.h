// Splits a body between two dips: which dip paints which place, and where the seam between them
// runs (docs/film-model.md, "Two dips, one body").
#pragma once

#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"
#include "model/TexturedMesh.h"
#include "settings/InkSettings.h"
#include "settings/ShareSettings.h"
#include "texture/PaintShare.h"

namespace dipwright {

// The areas that each dip paints, mm².
struct ShareAreas {
    double first = 0, second = 0; // painted by one dip alone
    double both = 0;              // painted by both, in the overlap along the seam
    double none = 0;              // painted by neither, without buried surface
    double total() const { return first + second + both + none; }
    bool operator==(const ShareAreas&) const = default;
};

enum class Painter : std::uint8_t { None, First, Second, Both };

// Width of the overlap along the seam, mm.
struct OverlapWidth {
    double least = 0, middle = 0, most = 0; // 5th, 50th and 95th percentile along the seam
};

// A connected piece of the body that neither dip reaches.
struct UnpaintedPlace {
    double area = 0; // mm²
    // A point of the piece near its middle; model coordinates, mm.
    Eigen::Vector3f place = Eigen::Vector3f::Zero();
};

// How visible a line on the body is. `cost` is the integral along the line of the texture's
// contrast times the place's visibility. Both factors range from 0.1 to about 1.
struct SeamCost {
    double length = 0; // mm
    double cost = 0;   // mm
};

// Immutable; any thread may read.
struct BodyShare {
    SurfaceField fade;                                // as in PaintShare
    float narrowest = 0;                              // as in PaintShare
    std::vector<Painter> painters;                    // per fine triangle
    std::vector<std::array<Eigen::Vector3f, 2>> join; // the seam, in pieces; model coordinates, mm
    OverlapWidth overlap;
    // Share of the overlap that is too narrow for the registration error. If the second film is
    // displaced by that error, the reflectance there changes by more than 0.1.
    double narrow = 0;
    ShareAreas areas;
    // Share of the painted area that marks assign to a dip, but that only the other dip paints.
    double misassigned = 0;
    // Third quartile of the stretch of each dip's film along the seam. A displacement of the film
    // on the water is multiplied by this stretch on the body.
    std::array<double, 2> seamStretch{1, 1};
    SeamCost cost; // cost of the seam
    // For comparison: cost of the plane halfway between the two poses. It is moved so that
    // everything that a dip reaches is painted.
    SeamCost equator;
    std::vector<UnpaintedPlace> unpainted; // largest first

    // Returns the share that dip `number` (0 or 1) paints.
    PaintShare of(std::size_t number) const { return {fade, number == 0, narrowest}; }
};

// The parts of a split that depend on no film: the body's fine triangles, and how visible a seam is
// on each.
struct ShareStage;
// Computes the stage for a body that is to look like `model`. `fine` is fineBody() of its mesh.
// Uses all cores. Any thread may read the stage.
std::shared_ptr<const ShareStage> shareStage(const TexturedMesh& model,
                                             std::shared_ptr<const RefinedMesh> fine);

// Splits the body of `stage` between its two dips; `films` are their results. Uses all cores;
// deterministic. Throws Cancelled.
BodyShare shareBody(const ShareStage& stage,
                    const std::array<std::shared_ptr<const LaidFilm>, 2>& films,
                    const ShareSettings& settings, const InkSettings& ink,
                    const Progress& progress);

// Returns which dip (0 or 1) should come last: the one whose film is stretched less along the seam,
// because only the last film is misregistered. Returns nothing if the stretches hardly differ.
std::optional<std::size_t> recommendedLastDip(const BodyShare& share);

} // namespace dipwright

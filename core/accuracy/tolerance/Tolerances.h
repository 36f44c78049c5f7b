// Computes how far colours of one dip may land from their places within the handling tolerances:
// contributions, worst places, and a check by sampled dips (docs/film-model.md, "Tolerances").
#pragma once

#include "accuracy/tolerance/Contributors.h"
#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"
#include "settings/FilmSettings.h"
#include "settings/ProcessSettings.h"

#include <functional>

namespace dipwright {

struct DistanceField;

// Statistics over the painted places, mm.
struct Spread {
    double median = 0, percentile95 = 0, maximum = 0;
};
Spread spreadOf(std::vector<float> values);

// The effect of one contributor alone when it deviates by its tolerance.
struct Contribution {
    Contributor contributor = Contributor::PositionX;
    double tolerance = 0; // in the contributor's unit
    double share = 0;     // share of the total mean square; all shares add up to 1
    Spread spread;
    double lost = 0;   // mm² at the border that lose their paint; the larger of both directions
    double gained = 0; // mm² at the border that are newly painted; the larger of both directions
};

struct WorstPlace {
    Eigen::Vector3f place = Eigen::Vector3f::Zero();  // model coordinates, mm
    double spread = 0;                                // mm
    Contributor contributor = Contributor::PositionX; // the largest contributor
};

// The spread from sampled dips, in which all contributors deviate at once.
struct SampledSpread {
    int dips = 0;
    double percentile95 = 0; // mm
    double linear = 0;       // spread from the contributions at the same places, mm
    // Tells whether both spreads agree within sampledTolerance.
    bool agrees() const;
};

// The tolerances of one dip. The spread of a place is two standard deviations of where its colour
// lands. If the colour deviates along one line only, it lands within the spread in 95 % of dips; if
// it deviates equally in all directions, in 98 %; otherwise in between.
struct DipTolerances {
    std::vector<Contribution>
        contributions;         // for each listed contributor with a tolerance, in enum order
    std::vector<float> places; // spread of each compared place, mm, or unpaintedPlace
    // For each contribution, in order: its squared effect at each compared place, mm².
    std::vector<std::vector<float>> squares;
    std::vector<float> pieces; // spread of each triangle of toleranceMesh(), mm, or unpaintedPlace
    std::vector<float> filmPoints; // spread of each film point, mm; 0 where the film does not paint
    Spread spread;
    std::vector<WorstPlace> worst; // places at some distance from each other, the worst first
    std::optional<SampledSpread> sampled; // none if no samples were asked for
};
inline constexpr float unpaintedPlace = -1;
// Returns the spread and largest contributor of the compared place `place`, which lies at
// `position`.
WorstPlace worstAt(const DipTolerances& tolerances, std::size_t place,
                   const Eigen::Vector3f& position);
inline constexpr double sampledTolerance = 0.1; // largest relative difference of both spreads

// Tells the user whether the sampled dips agree with the contributions. `length` formats mm.
QString sampledText(const SampledSpread& sampled, const std::function<QString(double)>& length);

// The input of dipTolerances().
struct TolerancedDip {
    const TexturedMesh& model; // imported model, mm
    const Immersion& immersion;
    const FilmSettings& film;
    const ProcessSettings& process;
    const DistanceField& field;
    std::shared_ptr<const LaidFilm> own; // the film of the nominal dip
    // Tells whether this dip should paint a place; empty: it paints every place that it reaches.
    std::function<bool(const SurfacePoint&)> isPainted;
    const solver::SolverModule& module;
};

// Returns the compared places. They are spread evenly; each stands for the same area.
std::vector<SurfacePoint> tolerancePlaces(const TexturedMesh& model);
// Returns a finely divided mesh of the body, for marking zones and showing tolerances.
RefinedMesh toleranceMesh(const TexturedMesh& model);

// Computes the tolerances of a dip. Simulates two dips for each Freedom and settings.samples
// further dips. Uses all cores; deterministic. Throws Error if the solver fails, or Cancelled.
DipTolerances dipTolerances(const TolerancedDip& dip, const ToleranceSettings& settings,
                            const Progress& progress);

} // namespace dipwright

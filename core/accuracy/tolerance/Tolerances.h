// How far the colours of one dip may be off for what is off in it: contributions, worst places and
// a check with dips in which all is off at once (docs/film-model.md, "Tolerances").
#pragma once

#include "accuracy/tolerance/Contributors.h"
#include "base/Progress.h"
#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"
#include "settings/FilmSettings.h"
#include "settings/ProcessSettings.h"

#include <functional>

namespace dipwright {

class DistanceField;

// mm, over the painted places.
struct Spread {
    double median = 0, percentile95 = 0, maximum = 0;
};
Spread spreadOf(std::vector<float> values);

// What one contributor does by itself, off by its tolerance.
struct Contribution {
    Contributor contributor = Contributor::PositionX;
    double tolerance = 0; // in its unit
    double share = 0;     // of the mean square of all; these add up to 1
    Spread spread;
    double lost = 0;   // mm² at the border that are not painted any more, the larger of both ways
    double gained = 0; // and that are painted besides
};

struct WorstPlace {
    Eigen::Vector3f place = Eigen::Vector3f::Zero();  // model coordinates, mm
    double spread = 0;                                // mm
    Contributor contributor = Contributor::PositionX; // that has the largest part in it
};

// The same by dips in which everything is off at once.
struct SampledSpread {
    int dips = 0;
    double percentile95 = 0; // mm …
    double linear = 0;       // … and what the contributions come to at the same places
    bool agrees() const;     // to a tenth
};

// Two standard deviations of where each colour comes to lie: of 100 dips it lies no farther off in
// 95 (all is off along one line) to 98 (alike in all directions).
struct DipTolerances {
    std::vector<Contribution> contributions; // those with a tolerance, in the enumeration's order
    std::vector<float> places;               // a compared place each, mm; unpaintedPlace
    // A compared place each: squares of what each contributor does there, mm²; in the order of the
    // contributions.
    std::vector<std::vector<float>> squares;
    std::vector<float> pieces;     // a triangle of toleranceMesh() each, mm; unpaintedPlace
    std::vector<float> filmPoints; // a film point each, mm; 0 where it does not paint
    Spread spread;
    std::vector<WorstPlace> worst;        // apart from each other, the worst first
    std::optional<SampledSpread> sampled; // none where no dips are to be done for it
};
inline constexpr float unpaintedPlace = -1;
// One of the compared places, which lies at `position`.
WorstPlace worstAt(const DipTolerances& tolerances, std::size_t place,
                   const Eigen::Vector3f& position);
inline constexpr double sampledTolerance = 0.1; // by which the dips with all off may differ

// For the user, whether that is what the contributions come to. `length` words a length given in
// mm.
QString sampledText(const SampledSpread& sampled, const std::function<QString(double)>& length);

struct TolerancedDip {
    const TexturedMesh& model; // as imported, mm
    const Immersion& immersion;
    const FilmSettings& film;
    const ProcessSettings& process;
    const DistanceField& field;
    std::shared_ptr<const LaidFilm> own; // as it is to be
    // The places that are this dip's to paint; empty: all that it reaches.
    std::function<bool(const SurfacePoint&)> isPainted;
    const solver::SolverModule& module;
};

// The places of the body that tolerances are told of: spread evenly, each standing for as much.
std::vector<SurfacePoint> tolerancePlaces(const TexturedMesh& model);
// The body cut finely, to mark zones on and to show tolerances by.
RefinedMesh toleranceMesh(const TexturedMesh& model);

// Dips twice for each way in which a dip can be off, and settings.samples times more. All cores;
// deterministic. Throws Error when the solver fails, Cancelled.
DipTolerances dipTolerances(const TolerancedDip& dip, const ToleranceSettings& settings,
                            const Progress& progress);

} // namespace dipwright

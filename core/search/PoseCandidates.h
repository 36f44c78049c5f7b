// Finds candidate poses from the body's shape alone: the first stage of the pose search.
#pragma once

#include "base/Progress.h"
#include "search/CoveragePreview.h"
#include "settings/SearchSettings.h"

namespace dipwright {

struct PoseCandidate {
    Eigen::Vector3d down; // direction that goes down first, model coordinates, unit length
    double coverage = 0;  // previewed share of the surface
    double promise = 0;   // previewed quality, 0 … 1
    Immersion immersion;  // turned about the vertical to fit the film best
    std::size_t like = 0; // the first candidate that looks the same from the film; or itself
};

// Returns an immersion with a direction of the model down. It is turned about the vertical so that
// the outline takes the smallest share of the film's sides.
Immersion immersionFor(const TriangleMesh& mesh, const Eigen::Vector3d& down,
                       const solver::FilmGrid& film);
// Returns the direction of the model that points down in an immersion.
Eigen::Vector3d downOf(const Immersion& immersion);

struct PoseCandidates {
    std::vector<PoseCandidate> all; // settings.directions candidates, the box's six sides first
    // Candidates to simulate, at most settings.simulated: the sides, then the most promising,
    // spread over all directions. Candidates that are like an earlier one are left out.
    std::vector<std::size_t> chosen;
};

// `zoneWeights`: of each triangle of preview.mesh(). All cores, deterministic; throws Cancelled.
PoseCandidates poseCandidates(const CoveragePreview& preview, const std::vector<float>& zoneWeights,
                              const FilmSettings& film, const ProcessSettings& process,
                              const SearchSettings& settings, const Progress& progress);

} // namespace dipwright

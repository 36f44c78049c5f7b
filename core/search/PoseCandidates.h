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
    // Index of the first candidate that looks the same from the film; its own index if none does.
    std::size_t like = 0;
};

// Returns the settings of a dip in which `down` points down. The body is turned about the vertical
// so that its outline is smallest relative to the film's sides.
Immersion immersionFor(const TriangleMesh& mesh, const Eigen::Vector3d& down,
                       const solver::FilmGrid& film);
// Returns the direction of the model that points down in a dip.
Eigen::Vector3d downOf(const Immersion& immersion);

struct PoseCandidates {
    std::vector<PoseCandidate> all; // settings.directions candidates, the box's six sides first
    // Candidates to simulate, at most settings.simulated: the sides, then the most promising,
    // spread over all directions. Candidates that are like an earlier one are left out.
    std::vector<std::size_t> chosen;
};

// Finds the candidates. `zoneWeights` holds the weight of each triangle of preview.mesh(). Uses all
// cores; deterministic. Throws Cancelled.
PoseCandidates poseCandidates(const CoveragePreview& preview, const std::vector<float>& zoneWeights,
                              const FilmSettings& film, const ProcessSettings& process,
                              const SearchSettings& settings, const Progress& progress);

} // namespace dipwright

// The first stage of the pose search: poses by the body's shape alone.
#pragma once

#include "base/Progress.h"
#include "search/CoveragePreview.h"
#include "settings/SearchSettings.h"

namespace dipwright {

struct PoseCandidate {
    Eigen::Vector3d down; // of the model, unit: what goes down first
    double coverage = 0;  // previewed, share of the surface
    double promise = 0;   // previewed quality, 0 … 1
    Immersion immersion;  // turned about the vertical so that it fits the film best
    std::size_t like = 0; // the first candidate with the same shape seen from the film; or itself
};

// The immersion with a direction of the model down, turned about the vertical so that its outline
// takes the smallest share of the film's sides.
Immersion immersionFor(const TriangleMesh& mesh, const Eigen::Vector3d& down,
                       const solver::FilmGrid& film);
// The direction of the model that points down in an immersion.
Eigen::Vector3d downOf(const Immersion& immersion);

struct PoseCandidates {
    std::vector<PoseCandidate> all; // settings.directions: the six sides of the box first
    // Those to be simulated, settings.simulated at most: the sides, then those of most promise,
    // spread over all directions; of those alike the first.
    std::vector<std::size_t> chosen;
};

// `zoneWeights`: a triangle of preview.mesh() each. All cores, deterministic; throws Cancelled.
PoseCandidates poseCandidates(const CoveragePreview& preview, const std::vector<float>& zoneWeights,
                              const FilmSettings& film, const ProcessSettings& process,
                              const SearchSettings& settings, const Progress& progress);

} // namespace dipwright

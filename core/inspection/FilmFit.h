// Fits the film, its placement and the depth of a dip to the places where the print was seen on a
// dipped part (docs/inspection.md, "The fit").
#pragma once

#include "base/Progress.h"
#include "geometry/DistanceField.h"
#include "inspection/FitQuantities.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"
#include "settings/FilmSettings.h"
#include "settings/Immersion.h"

#include <optional>
#include <vector>

namespace dipwright {

struct Project;

// The places that were found in photos of one dipped part. All photos are from one camera and have
// the same size.
struct FitPairs {
    std::vector<PrintedPlace> printed;
    // Places on the body itself, independent of the print; they separate the camera from the film.
    // If empty, the first camera is fitted to the intended places of the print.
    std::vector<PlacePair> body;
    int photos = 1;
    QSize picture; // pixels
    QString where; // names the pairs for the user
};

struct FitRequest {
    // Empty: the usualQuantities() that the pairs determine.
    std::vector<FitQuantity> quantities;
    bool keepsBodyCamera = false; // keeps the camera that fits the body's places alone
    std::optional<Lens> lens;     // known from an earlier measurement of the camera
};

// A fitted quantity, in its own unit. Shifts are offsets on the water; a turn counts from the
// project's pose.
struct FittedQuantity {
    FitUnknown unknown;
    double before = 0, after = 0;
    double low = 0, high = 0; // 95 % interval
};

// The distance of one printed place, seen minus expected. `before` is measured with the project's
// quantities and the camera that fits them best.
struct FitDistance {
    bool isOnBody =
        false; // whether the fitted simulation paints the place; if not, ignore the rest
    Eigen::Vector2d before{0, 0}, after{0, 0}; // pixels
    double millimetres = 0;                    // `after` in mm, across the line of sight
};

struct FilmFit {
    std::vector<FittedQuantity> quantities;
    Eigen::MatrixXd correlation; // correlations between `quantities`
    // Quantities that the pairs do not determine; they keep their values. Empty if the user named
    // quantities.
    std::vector<FitUnknown> left;
    // Why relaxation is not known to within 10 %, and what to photograph; empty if it is.
    QString doubt;
    std::vector<FitDistance> off;             // one per printed place
    PartView view;                            // camera; its `figures` are not set
    double beforePixels = 0, afterPixels = 0; // root mean square distances
    double beforeMillimetres = 0, afterMillimetres = 0;
    int dips = 0, rounds = 0;
    // The project's settings with the fitted values.
    FilmSettings film;
    std::vector<Immersion> immersions;
    std::optional<Millimetres> depth;
};

// Simulates dips near the project's settings, moves the quantities to the best match with the
// pairs, and repeats. Ends when no quantity moves by more than 5 % of its 95 % interval. Uses all
// cores; deterministic. Throws Cancelled. Throws Error if the pairs do not determine a named
// quantity; the message says which quantities the pairs cannot separate and what to photograph.
// Also throws Error if the places stay millimetres off, or nearly as far off as they were.
FilmFit fitFilm(const Project& project, const DistanceField& field, const FitPairs& pairs,
                const FitRequest& wish, const solver::SolverModule& module,
                const Progress& progress);

} // namespace dipwright

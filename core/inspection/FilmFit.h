// The film, its place and the depth of a dip, fitted to where printed places were seen on a dipped
// part (docs/inspection.md, "The fit").
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

// What photos of one dipped part show. Photos of one camera and size.
struct FitPairs {
    std::vector<PrintedPlace> printed;
    // Places of the body itself, whatever is printed there: they tell the camera from the film.
    // Empty: the camera is begun with where the printed places are meant to be.
    std::vector<PlacePair> body;
    int photos = 1;
    QSize picture; // pixels
    QString where; // names the pairs for the user
};

struct FitWish {
    // Empty: of usualQuantities() those that the pairs determine.
    std::vector<FitQuantity> quantities;
    bool holdsCamera = false; // as the places of the body alone have it
    std::optional<Lens> lens; // of a camera measured before
};

// In the quantity's own unit; shifts are offsets on the water, a turn counts from the project's
// pose.
struct FittedQuantity {
    FitUnknown unknown;
    double before = 0, after = 0;
    double low = 0, high = 0; // 95 %
};

// One printed place, seen less expected.
struct FitOff {
    bool isOnBody = false; // in the simulation that fits; else the rest means nothing
    Eigen::Vector2d before{0, 0}, after{0, 0}; // pixels; before: by the camera that fits best then
    double millimetres = 0;                    // after, across the line of sight
};

struct FilmFit {
    std::vector<FittedQuantity> quantities;
    Eigen::MatrixXd correlation; // of them
    // What the pairs do not determine, where nothing was named that is to be fitted: as it was.
    std::vector<FitUnknown> left;
    // Why relaxation is not known to a tenth, and what to photograph; empty where it is.
    QString doubt;
    std::vector<FitOff> off;                  // a printed place each
    PartView view;                            // its figures are not filled in
    double beforePixels = 0, afterPixels = 0; // root mean square distance
    double beforeMillimetres = 0, afterMillimetres = 0;
    int dips = 0, rounds = 0;
    // The project's, with what was fitted.
    FilmSettings film;
    std::vector<Immersion> immersions;
    std::optional<Millimetres> depth;
};

// Dips near what the project says, moves what is to be fitted to where the pairs are met best, and
// dips again until nothing moves by more than a twentieth of its 95 % interval. All cores;
// deterministic. Throws Error where the pairs do not tell what was named, saying what they cannot
// tell apart and what to photograph; Cancelled.
FilmFit fitFilm(const Project& project, const DistanceField& field, const FitPairs& pairs,
                const FitWish& wish, const solver::SolverModule& module, const Progress& progress);

} // namespace dipwright

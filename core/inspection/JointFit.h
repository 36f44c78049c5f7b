// Film and camera fitted to one set of pairs together, near dips that have been simulated. Private
// to this folder.
#pragma once

#include "inspection/FitQuantities.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"

#include <optional>

namespace dipwright {

struct SeenPlaces {
    const std::vector<PrintedPlace>& printed;
    const std::vector<PlacePair>& body; // of the body itself, whatever is printed
    QSize picture;
};

// Where printed places lie on the model, to first order near what was simulated.
struct PlacesNear {
    std::vector<FitUnknown> unknowns;
    Eigen::VectorXd centre; // of the unknowns
    // A place each, mm; nothing where it is not on the body, or on film whose way is not known.
    std::vector<std::optional<Eigen::Vector3d>> places;
    // A place each; a column an unknown.
    std::vector<Eigen::Matrix3Xd> slopes;
};

enum class CameraFit : std::uint8_t { Whole, KnownLens, Held }; // what of it is fitted

struct JointSolution {
    Eigen::VectorXd unknowns; // those that were held are as they were given
    PartView view;
    double pixels = 0;           // standard deviation of what remains, along each axis
    Eigen::VectorXd off;         // 95 % of the unknowns, 0 of those that were held
    Eigen::MatrixXd correlation; // of those that were not held, in their order
    // Of those that were not held: the largest correlation, by size, with one of the camera's.
    Eigen::VectorXd withCamera;
    std::vector<Eigen::Vector2d> seenOff; // a printed place each, seen less expected; pixels
};

// `isFree`: of the unknowns, which are fitted; the others stay as in near.centre. Each is held to 0
// as by a spring that is weak beside all that counts as known, so that there is always a solution.
// Throws Error where it is not found.
JointSolution fitJointly(const PlacesNear& near, const SeenPlaces& seen, const PartView& start,
                         const std::vector<bool>& isFree, CameraFit camera, const QString& where);

} // namespace dipwright

// Fits film and camera together to one set of pairs, near simulated dips. Private to this folder.
#pragma once

#include "inspection/FitQuantities.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"

#include <optional>

namespace dipwright {

struct SeenPlaces {
    const std::vector<PrintedPlace>& printed;
    const std::vector<PlacePair>& body; // on the body itself, independent of the print
    QSize picture;
};

// Where printed places lie on the model, to first order near the simulation.
struct PlacesNear {
    std::vector<FitUnknown> unknowns;
    Eigen::VectorXd centre; // of the unknowns
    // One per place, mm; none if the place is not painted or its film is marked (torn, released or
    // not converged).
    std::vector<std::optional<Eigen::Vector3d>> places;
    // One per place, with one column per unknown.
    std::vector<Eigen::Matrix3Xd> slopes;
};

enum class CameraFit : std::uint8_t { Whole, KnownLens, Held }; // what is fitted

struct JointSolution {
    Eigen::VectorXd unknowns; // held unknowns keep the given values
    PartView view;
    double pixels = 0;           // standard deviation of the residuals, along each axis
    Eigen::VectorXd off;         // 95 % intervals of the unknowns; 0 for held ones
    Eigen::MatrixXd correlation; // of the free unknowns, in their order
    // For each free unknown, its largest absolute correlation with a parameter of the camera.
    Eigen::VectorXd withCamera;
    std::vector<Eigen::Vector2d> seenOff; // one per printed place, seen minus expected; pixels
};

// Fits the unknowns with `isFree`; the others keep their values in near.centre. A weak spring pulls
// each unknown to 0, so that there is always a solution; it is negligible beside what counts as
// known. Throws Error if no solution is found.
JointSolution fitJointly(const PlacesNear& near, const SeenPlaces& seen, const PartView& start,
                         const std::vector<bool>& isFree, CameraFit camera, const QString& where);

} // namespace dipwright

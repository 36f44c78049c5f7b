// Fits the film and the camera together to one set of pairs, linearly near a simulated dip. Private
// to this folder.
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

// Where printed places lie on the model, as a linear function of the unknowns near the simulation.
struct PlacesNear {
    std::vector<FitUnknown> unknowns;
    Eigen::VectorXd centre; // values of the unknowns in the simulation
    // The position of each place at `centre`, mm. None if the place is not painted or its film is
    // marked (torn, released or not converged).
    std::vector<std::optional<Eigen::Vector3d>> places;
    // The derivatives of each place's position: one column per unknown.
    std::vector<Eigen::Matrix3Xd> slopes;
};

// Which part of the camera is fitted: all of it, all except its lens, or nothing.
enum class CameraFit : std::uint8_t { Whole, KnownLens, Held };

struct JointSolution {
    Eigen::VectorXd unknowns; // held unknowns keep the given values
    PartView view;
    double pixels = 0;           // standard deviation of the residuals, along each axis
    Eigen::VectorXd off;         // 95 % intervals of the unknowns; 0 for held ones
    Eigen::MatrixXd correlation; // correlations between the free unknowns, in their order
    // For each free unknown, its largest absolute correlation with a parameter of the camera.
    Eigen::VectorXd cameraCorrelation;
    std::vector<Eigen::Vector2d>
        seenDistances; // one per printed place, seen minus expected; pixels
};

// Fits the unknowns that `isFree` marks; the others keep their values in near.centre. A weak spring
// pulls each unknown to 0, so that there is always a solution. It does not noticeably change an
// unknown that counts as known. Throws Error if no solution is found.
JointSolution fitJointly(const PlacesNear& near, const SeenPlaces& seen, const PartView& start,
                         const std::vector<bool>& isFree, CameraFit camera, const QString& where);

} // namespace dipwright

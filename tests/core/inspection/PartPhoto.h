// Makes photos of a printed part by ray tracing.
#pragma once

#include "Photograph.h"
#include "dip/LaidFilm.h"

#include <Eigen/Geometry>

#include <functional>

namespace dipwright::test {

struct PhotoCamera : PhotoLens {
    // From the model's frame to the camera's, mm.
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

    Eigen::Vector2d seen(const Eigen::Vector3d& place) const; // pixels
    // Tells whether the camera sees this place of the surface at a sufficiently steep angle.
    bool faces(const Eigen::Vector3d& place, const Eigen::Vector3d& outward) const;
    Eigen::Vector3d eye() const { return pose.inverse() * Eigen::Vector3d::Zero().eval(); }
};

// Returns a camera at `from` that looks at the model's place `at`, with `up` upwards in the
// picture.
PhotoCamera cameraFrom(const Eigen::Vector3d& from, const Eigen::Vector3d& at,
                       const Eigen::Vector3d& up);

// Returns the reflectance of a place of the body, 0 … 1.
using Print = std::function<double(const SurfacePoint& place)>;

// Returns the print of a laid film: chess squares of `square` mm that start at the middle of the
// sheet. The bare surface is grey. Keeps a reference to `laid`.
Print chessboardPrint(const LaidFilm& laid, QSizeF sheet, double square);

// Returns a photo of the printed body.
QImage partPhoto(const TriangleMesh& body, const Print& print, const PhotoCamera& camera,
                 const PhotoLight& light);

} // namespace dipwright::test

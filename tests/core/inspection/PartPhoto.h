// Makes photos of a part by rays onto the body and its print.
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
    // Whether the camera sees this place of the surface, not at too flat an angle.
    bool faces(const Eigen::Vector3d& place, const Eigen::Vector3d& outward) const;
    Eigen::Vector3d eye() const { return pose.inverse() * Eigen::Vector3d::Zero().eval(); }
};

// A camera at `from` that looks at the model's place `at`, with `up` upwards in the picture.
PhotoCamera cameraFrom(const Eigen::Vector3d& from, const Eigen::Vector3d& at,
                       const Eigen::Vector3d& up);

// The reflectance of a place of the body, 0 … 1.
using Print = std::function<double(const SurfacePoint& place)>;

// The print of a laid film: chess squares of `square` mm from the middle of its sheet, grey on the
// bare surface. Keeps a reference to `laid`.
Print chessboardPrint(const LaidFilm& laid, QSizeF sheet, double square);

QImage partPhoto(const TriangleMesh& body, const Print& print, const PhotoCamera& camera,
                 const PhotoLight& light);

} // namespace dipwright::test

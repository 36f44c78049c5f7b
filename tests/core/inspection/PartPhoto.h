// Photos of a part: rays onto the body, whose print is asked place by place.
#pragma once

#include "Photograph.h"
#include "dip/LaidFilm.h"

#include <Eigen/Geometry>

#include <functional>

namespace dipwright::test {

struct PhotoCamera : PhotoLens {
    // From the model to the camera.
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

    Eigen::Vector2d seen(const Eigen::Vector3d& place) const; // pixels
    // Whether it looks at the body there, and not all too much along it.
    bool faces(const Eigen::Vector3d& place, const Eigen::Vector3d& outward) const;
    Eigen::Vector3d eye() const { return pose.inverse() * Eigen::Vector3d::Zero().eval(); }
};

// One that looks at the model's place `at` from there, `up` upwards in the picture.
PhotoCamera cameraFrom(const Eigen::Vector3d& from, const Eigen::Vector3d& at,
                       const Eigen::Vector3d& up);

// How much light a place of the body sends back, 0 … 1.
using Print = std::function<double(const SurfacePoint& place)>;

// Of a film that has come to lie on a body: chess squares of `square` mm from the middle of its
// sheet, grey where it covers nothing. Keeps the reference.
Print chessboardPrint(const LaidFilm& laid, QSizeF sheet, double square);

QImage partPhoto(const TriangleMesh& body, const Print& print, const PhotoCamera& camera,
                 const PhotoLight& light);

} // namespace dipwright::test

// Photos of a part, made by another way than they are read: rays from a pinhole camera with a lens
// of given distortion onto the body, whose print is asked place by place.
#pragma once

#include "PhotoLight.h"
#include "geometry/TriangleMesh.h"

#include <functional>

namespace dipwright::test {

struct PhotoCamera {
    QSize size{1344, 1344};   // the paper's
    double focalLength = 2.2; // half diagonals
    double k1 = 0, k2 = 0;
    // From the model to the camera: right, down and forward in the picture.
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

    Eigen::Vector2d seen(const Eigen::Vector3d& place) const;  // pixels
    Eigen::Vector3d sight(const Eigen::Vector2d& pixel) const; // in the model's frame
    Eigen::Vector3d eye() const { return pose.inverse() * Eigen::Vector3d::Zero().eval(); }
};

// One that looks at the model's place `at` from there, `up` upwards in the picture.
PhotoCamera cameraFrom(const Eigen::Vector3d& from, const Eigen::Vector3d& at,
                       const Eigen::Vector3d& up);

// How much light a place of the body sends back, 0 … 1.
using Print = std::function<double(const SurfacePoint& place)>;

QImage partPhoto(const TriangleMesh& body, const Print& print, const PhotoCamera& camera,
                 const PhotoLight& light);

} // namespace dipwright::test

// Makes photos independently of the code that reads them. Rays go through a pinhole and a lens of
// given distortion, in linear light. Light, focus, noise and encoding are applied afterwards.
#pragma once

#include <Eigen/Core>

#include <QImage>
#include <functional>

namespace dipwright::test {

// A lens. The camera's frame is right, down and forward in the picture.
struct PhotoLens {
    QSize size{1344, 1344};   // the paper's
    double focalLength = 2.2; // half diagonals
    double k1 = 0, k2 = 0;

    Eigen::Vector2d pixelOf(const Eigen::Vector3d& place) const; // of a place in the camera's frame
    Eigen::Vector3d sight(const Eigen::Vector2d& pixel) const;   // the pixel's direction, 1 forward
};

struct PhotoLight {
    double blur = 0.7;    // pixels, standard deviation
    double noise = 1;     // levels of 255
    double uneven = 0.4;  // share by which the left is darker
    bool glare = false;   // a bright spot
    int jpegQuality = 85; // 0: not through JPEG
    unsigned seed = 1;
};

// The light from a direction, 0 … 1. Many threads call it.
using LightFrom = std::function<double(const Eigen::Vector3d& sight)>;

// Makes a photo. Each pixel takes `samples` × `samples` rays; where the light is even, only the
// rays at its corners.
QImage photograph(const PhotoLens& lens, int samples, const LightFrom& lightFrom,
                  const PhotoLight& light);

} // namespace dipwright::test

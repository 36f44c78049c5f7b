// Makes photos independently of the code that reads photos. Traces rays in linear light through a
// pinhole and a lens of given distortion. Then applies uneven light, blur, noise and encoding.
#pragma once

#include <Eigen/Core>

#include <QImage>
#include <functional>

namespace dipwright::test {

// A lens. The camera's frame is right, down and forward in the picture.
struct PhotoLens {
    QSize size{1344, 1344};   // pixels, as in the paper
    double focalLength = 2.2; // half diagonals
    double k1 = 0, k2 = 0;

    // Returns the pixel of a place in the camera's frame.
    Eigen::Vector2d pixelOf(const Eigen::Vector3d& place) const;
    // Returns the direction of a pixel, with a forward component of 1.
    Eigen::Vector3d sight(const Eigen::Vector2d& pixel) const;
};

struct PhotoLight {
    double blur = 0.7;    // standard deviation, pixels
    double noise = 1;     // levels of 255
    double uneven = 0.4;  // share by which the left side is darker
    bool glare = false;   // whether there is a bright spot
    int jpegQuality = 85; // 0: no JPEG compression
    unsigned seed = 1;
};

// A function that returns the light from a direction, 0 … 1. Many threads call it.
using LightFrom = std::function<double(const Eigen::Vector3d& sight)>;

// Returns a photo. Each pixel takes `samples` × `samples` rays; where the light is even, only the
// rays at the pixel's corners.
QImage photograph(const PhotoLens& lens, int samples, const LightFrom& lightFrom,
                  const PhotoLight& light);

} // namespace dipwright::test

// Photos made by another way than they are read: rays through a pinhole and a lens of given
// distortion, in linear light, then what light, focus and a camera's chip make of them, encoded.
#pragma once

#include <Eigen/Core>

#include <QImage>
#include <functional>

namespace dipwright::test {

// A camera's frame: right, down and forward in the picture.
struct PhotoLens {
    QSize size{1344, 1344};   // the paper's
    double focalLength = 2.2; // half diagonals
    double k1 = 0, k2 = 0;

    Eigen::Vector2d pixelOf(const Eigen::Vector3d& place) const; // in the camera's frame
    Eigen::Vector3d sight(const Eigen::Vector2d& pixel) const;   // the same, 1 forward
};

struct PhotoLight {
    double blur = 0.7;    // pixels, standard deviation
    double noise = 1;     // levels of 255
    double uneven = 0.4;  // how much darker it is on the left
    bool glare = false;   // a bright spot
    int jpegQuality = 85; // 0: none
    unsigned seed = 1;
};

// How much light comes from there, 0 … 1; asked by many threads.
using LightFrom = std::function<double(const Eigen::Vector3d& sight)>;

// `samples` by `samples` rays a pixel at edges; where light is even, those at the pixel's corners.
QImage photograph(const PhotoLens& lens, int samples, const LightFrom& lightFrom,
                  const PhotoLight& light);

} // namespace dipwright::test

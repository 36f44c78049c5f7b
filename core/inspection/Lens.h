// What a camera's lens does to a picture, by radial distortion (the two first terms of Brown's).
#pragma once

#include <Eigen/Core>

#include <QSize>

namespace dipwright {

// Places in a picture are in pixels from its upper left corner, to the right and down: the middle
// of the first pixel is (½, ½).
struct Lens {
    // q (1 + k1 q² + k2 q⁴) is where q appears, both from the picture's middle over half its
    // diagonal.
    double k1 = 0, k2 = 0;
};

// From pixels to what the distortion is a function of, and back.
class LensPlane {
public:
    explicit LensPlane(QSize picture);

    Eigen::Vector2d inUnits(const Eigen::Vector2d& pixel) const;
    Eigen::Vector2d inPixels(const Eigen::Vector2d& place) const;
    double unit() const { return unit_; } // pixels: half the diagonal

private:
    Eigen::Vector2d middle_;
    double unit_;
};

// Both in units of LensPlane.
Eigen::Vector2d distorted(const Eigen::Vector2d& place, const Lens& lens);
// The place that appears at `seen`; `seen` itself where there is none near.
Eigen::Vector2d undistorted(const Eigen::Vector2d& seen, const Lens& lens);

} // namespace dipwright

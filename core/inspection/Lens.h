// Models a camera lens by radial distortion (the first two terms of Brown's model).
#pragma once

#include <Eigen/Core>

#include <QSize>

namespace dipwright {

// Places in a picture are in pixels from its upper left corner, to the right and down: the middle
// of the first pixel is (½, ½).
struct Lens {
    // A place at the distance q from the picture's middle appears at q (1 + k1 q² + k2 q⁴).
    // Distances are divided by half the picture's diagonal.
    double k1 = 0, k2 = 0;
};

// Converts pixels to units of half the diagonal from the picture's middle, and back.
class LensPlane {
public:
    explicit LensPlane(QSize picture);

    Eigen::Vector2d inUnits(const Eigen::Vector2d& pixel) const;
    Eigen::Vector2d inPixels(const Eigen::Vector2d& place) const;
    double unit() const { return unit_; } // half the diagonal, pixels

private:
    Eigen::Vector2d middle_;
    double unit_;
};

// Returns where the lens shows a place. Places here and below are in units of LensPlane.
Eigen::Vector2d distorted(const Eigen::Vector2d& place, const Lens& lens);
// Returns the place that the lens shows at `seen`; `seen` itself if there is none nearby.
Eigen::Vector2d undistorted(const Eigen::Vector2d& seen, const Lens& lens);

} // namespace dipwright

// Makes photos of a tank by ray tracing: the water and the printed pages on it.
#pragma once

#include "Photograph.h"

namespace dipwright::test {

// A page on the water. In its coordinates, in mm, the water is z = 0. Seen from above, x points
// right and y down.
struct FloatingPage {
    QImage print; // grey, `size` mm large
    QSizeF size;
    Eigen::Matrix2d turn =
        Eigen::Matrix2d::Identity(); // swell and rotation about the page's middle
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double above = 0; // mm above the water
    // Returns the displacement of the film, in mm on the water. The argument is the place on the
    // page, in mm from the page's middle.
    std::function<Eigen::Vector2d(const Eigen::Vector2d&)> aside;

    Eigen::Vector2d onWater(const Eigen::Vector2d& onPage)
        const; // converts mm from the page's middle to mm on the water
};

struct TankCamera : PhotoLens {
    double height = 700;                     // mm above the water
    double tiltDegrees = 0, rollDegrees = 0; // tilt from the vertical, rotation about the axis
    Eigen::Vector2d over = Eigen::Vector2d::Zero(); // place on the water at which the camera looks

    TankCamera() : PhotoLens{{2000, 1500}, 1.5} {}
    // Returns the pixel of a place `above` mm above the water, counted from the picture's corner.
    Eigen::Vector2d seen(const Eigen::Vector2d& water, double above = 0) const;
};

// Returns a photo of pages on the water. Ignores `above` and `aside`.
QImage tankPhoto(const std::vector<FloatingPage>& pages, const TankCamera& camera,
                 const PhotoLight& light);

// A film that grows by the film model's law.
struct GrowingFilm {
    double swellX = 1.12, swellY = 1.05; // when the dip begins
    double rate = 0.004, limit = 0.1;
    double begin = 70; // seconds after the film was laid

    // Returns the film's length divided by its length at the beginning of the dip.
    double times(double seconds) const;
};

// Returns a photo of the film and its card, `seconds` after the film was laid on the water.
// `jpegQuality` is as in PhotoLight.
QImage tankPhoto(const GrowingFilm& film, double seconds, int jpegQuality);

// Return the printed pages of the film (A4) and of the card (A5).
FloatingPage filmPage();
FloatingPage cardPage();
// Returns the matrix that scales and then turns by `degrees`.
Eigen::Matrix2d turned(double degrees, double scaleX = 1, double scaleY = 1);

} // namespace dipwright::test

// Makes photos of a tank by rays onto the water and the printed pages on it.
#pragma once

#include "Photograph.h"

namespace dipwright::test {

// A page on the water. The water is z = 0; x points right and y down, seen from above, in mm.
struct FloatingPage {
    QImage print; // grey, `size` mm large
    QSizeF size;
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity(); // swell and rotation about its middle
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double above = 0; // mm above the water
    // How far the film is drawn aside, mm on the water, by the place on the page in mm from its
    // middle.
    std::function<Eigen::Vector2d(const Eigen::Vector2d&)> aside;

    Eigen::Vector2d
    onWater(const Eigen::Vector2d& onPage) const; // mm from the page's middle to mm on the water
};

struct TankCamera : PhotoLens {
    double height = 700;                            // mm above the water
    double tiltDegrees = 0, rollDegrees = 0;        // from the vertical, and about its axis
    Eigen::Vector2d over = Eigen::Vector2d::Zero(); // the place on the water that it looks at

    TankCamera() : PhotoLens{{2000, 1500}, 1.5} {}
    // The pixel of a place `above` mm above the water, from the picture's corner.
    Eigen::Vector2d seen(const Eigen::Vector2d& water, double above = 0) const;
};

// A photo of pages on the water. It ignores `above` and `aside`.
QImage tankPhoto(const std::vector<FloatingPage>& pages, const TankCamera& camera,
                 const PhotoLight& light);

// A film that grows as in the film model, relative to the beginning of the dip.
struct GrowingFilm {
    double swellX = 1.12, swellY = 1.05; // when the dip begins
    double rate = 0.004, limit = 0.1;
    double begin = 70; // seconds after the film was laid

    double times(double seconds) const; // its length relative to that at the beginning of the dip
};

// A photo of the film and its card, `seconds` after the film was laid. `jpegQuality` as in
// PhotoLight.
QImage tankPhoto(const GrowingFilm& film, double seconds, int jpegQuality);

// The printed pages of the film, A4, and of the card, A5.
FloatingPage filmPage();
FloatingPage cardPage();
Eigen::Matrix2d turned(double degrees, double scaleX = 1, double scaleY = 1);

} // namespace dipwright::test

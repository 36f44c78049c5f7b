// Photos of a tank: rays onto the water, on which the printed pages lie.
#pragma once

#include "Photograph.h"

namespace dipwright::test {

// A page on the water, which is z = 0; x to the right and y down as seen from above, mm.
struct FloatingPage {
    QImage print; // of `size` mm, grey
    QSizeF size;
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity(); // swell and rotation, of mm from its middle
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double above = 0; // mm over the water
    // Where the film is drawn aside from where it would lie, mm on the water by mm from its middle.
    std::function<Eigen::Vector2d(const Eigen::Vector2d&)> aside;

    Eigen::Vector2d onWater(const Eigen::Vector2d& onPage) const; // both from their own middle: mm
};

struct TankCamera : PhotoLens {
    double height = 700;                     // mm over the water
    double tiltDegrees = 0, rollDegrees = 0; // from looking straight down, and about its axis
    Eigen::Vector2d over = Eigen::Vector2d::Zero(); // the place on the water that it looks at

    TankCamera() : PhotoLens{{2000, 1500}, 1.5} {}
    // Pixels from the picture's corner; `above` mm over the water.
    Eigen::Vector2d seen(const Eigen::Vector2d& water, double above = 0) const;
};

// Of pages on the water itself, not drawn aside.
QImage tankPhoto(const std::vector<FloatingPage>& pages, const TankCamera& camera,
                 const PhotoLight& light);

// A film that grows as the film model has it, from when the dip begins.
struct GrowingFilm {
    double swellX = 1.12, swellY = 1.05; // when the dip begins
    double rate = 0.004, limit = 0.1;
    double begin = 70; // seconds after it was laid

    double times(double seconds) const; // how long it is then, times what it is at the begin
};

// It and its card, so many seconds after it was laid. `jpegQuality`: as of PhotoLight.
QImage tankPhoto(const GrowingFilm& film, double seconds, int jpegQuality);

// The film's page and the card's, A4 and A5, as they are printed.
FloatingPage filmPage();
FloatingPage cardPage();
Eigen::Matrix2d turned(double degrees, double scaleX = 1, double scaleY = 1);

} // namespace dipwright::test

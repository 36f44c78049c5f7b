// Photos of a tank, made by another way than they are read: rays from a pinhole camera with a lens
// of given distortion onto the water, on which the printed pages lie. All in linear light, then
// encoded.
#pragma once

#include "PhotoLight.h"

#include <Eigen/Core>

#include <QImage>
#include <functional>

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

struct TankCamera {
    QSize size{2000, 1500};
    double focalLength = 1.5; // half diagonals
    double k1 = 0, k2 = 0;
    double height = 700;                     // mm over the water
    double tiltDegrees = 0, rollDegrees = 0; // from looking straight down, and about its axis
    Eigen::Vector2d over = Eigen::Vector2d::Zero(); // the place on the water that it looks at

    // Pixels from the picture's corner; `above` mm over the water.
    Eigen::Vector2d seen(const Eigen::Vector2d& water, double above = 0) const;
    // The place at that height which is seen there.
    Eigen::Vector2d looksAt(const Eigen::Vector2d& pixel, double above = 0) const;
};

// Of pages on the water itself, not drawn aside.
QImage tankPhoto(const std::vector<FloatingPage>& pages, const TankCamera& camera,
                 const PhotoLight& light);

// The film's page and the card's, A4 and A5, as they are printed.
FloatingPage filmPage();
FloatingPage cardPage();
Eigen::Matrix2d turned(double degrees, double scaleX = 1, double scaleY = 1);

} // namespace dipwright::test

// How much a film that floats flat has grown over its print, by one photo of it and of a card
// beside it (docs/inspection.md, "From corners to swell").
#pragma once

#include "inspection/FindBoards.h"
#include "inspection/Lens.h"

#include <QSize>
#include <array>
#include <optional>
#include <vector>

namespace dipwright {

struct FlatSettings {
    // A camera measured before; none: both numbers come from the boards in the photo.
    std::optional<Lens> lens;
    // Measured over nominal length of the card's and of the dry film's rulers, across and down.
    std::array<double, 2> cardScale{1, 1}, filmScale{1, 1};
    // How far the card's print lies over the film, mm, and how long the camera's lens is, in half
    // diagonals of the picture: only needed for that.
    double cardAbove = 0;
    std::optional<double> focalLength;
};

// A number, and how far it may be off at 95 %: what the scatter of the corners makes of it, not the
// errors of what they are compared with.
struct Measured {
    double value = 0, off = 0;
};

struct FilmCorner {
    int column = 0, row = 0;     // of the board
    Eigen::Vector2d seen;        // pixels of the photo
    Eigen::Vector2d printed;     // mm on the sheet, from the board's upper left corner
    Eigen::Vector2d lies;        // mm on the water, in the card's frame
    Eigen::Vector2d off;         // `lies` less where an evenly swollen film would have it, mm
    std::optional<double> swell; // mean of both directions, there; none at the edge of what is seen
};

struct FlatFilm {
    Measured swellX, swellY; // wetted over printed length, along the board's rows and its columns
    double shearDegrees = 0; // how far the board's right angle is off
    std::vector<FilmCorner> corners;
    std::vector<Eigen::Vector2d> cardCorners; // pixels of the photo
    double residualPixels = 0;    // rms distance of the corners from where the fit has them
    double unevenMillimetres = 0; // 95th percentile of `off`
    Lens lens;
};

// Places of `film` and `card` are pixels of a picture of that size. Throws Error where the corners
// are too few or do not tell what is asked: `where` names the photo.
FlatFilm fitFlatFilm(const SeenBoard& film, const SeenBoard& card, QSize picture,
                     const FlatSettings& settings, const QString& where);

} // namespace dipwright

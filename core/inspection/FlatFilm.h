// Measures how much a flat floating film has grown since it was printed, from one photo of the film
// and of a card beside it (docs/inspection.md, "From corners to swell").
#pragma once

#include "inspection/FindBoards.h"
#include "inspection/Lens.h"

#include <QSize>
#include <array>
#include <optional>
#include <vector>

namespace dipwright {

struct FlatSettings {
    // Lens from an earlier measurement of the camera. None: k1 and k2 are fitted to the boards in
    // the photo.
    std::optional<Lens> lens;
    // Measured length divided by nominal length of the rulers on the card and on the dry film,
    // across and down.
    std::array<double, 2> cardScale{1, 1}, filmScale{1, 1};
    // Height of the card's print above the film, mm.
    double cardAbove = 0;
    // Focal length of the camera's lens, in half diagonals of the picture. Needed only if
    // `cardAbove` is not 0.
    std::optional<double> focalLength;
};

// A number and half the width of its 95 % interval. The interval includes the scatter of the
// corners, but no error of the reference lengths.
struct Measured {
    double value = 0, off = 0;
};

// Half the width of the 95 % interval of normally distributed errors, in standard deviations.
inline constexpr double deviationsFor95 = 1.959964;

struct FilmCorner {
    int column = 0, row = 0;     // on the board
    Eigen::Vector2d seen;        // pixels of the photo
    Eigen::Vector2d printed;     // mm on the sheet, from the board's upper left corner
    Eigen::Vector2d lies;        // mm on the water, in the card's frame
    Eigen::Vector2d off;         // `lies` minus the place on an evenly swollen film, mm
    std::optional<double> swell; // mean of both directions; none at the edge of the visible board
};

struct FlatFilm {
    // Floating length divided by printed length, along the board's rows and columns.
    Measured swellX, swellY;
    double shearDegrees = 0; // deviation of the board's right angle
    std::vector<FilmCorner> corners;
    std::vector<Eigen::Vector2d> cardCorners; // pixels of the photo
    double residualPixels = 0;        // root mean square distance of the corners from the fit
    double unevennessMillimetres = 0; // 95th percentile of `off`
    Lens lens;
};

// The places of `film` and `card` are pixels of a picture of size `picture`. Throws Error if the
// corners are too few or do not determine the film; `where` names the photo.
FlatFilm fitFlatFilm(const SeenBoard& film, const SeenBoard& card, QSize picture,
                     const FlatSettings& settings, const QString& where);

} // namespace dipwright

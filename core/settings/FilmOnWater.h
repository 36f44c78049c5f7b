// Photos of a floating film, and measurements taken beside them, as in the project file's
// "inspection.film".
#pragma once

#include "base/Units.h"
#include "settings/UnknownKeys.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace dipwright {

struct FloatingPhoto {
    QString file;   // path; the project does not contain the file
    QString sha256; // of the file, hexadecimal; empty: it was never read
    // Time since the film was laid, s; none: the photo was taken when the dip began.
    std::optional<double> seconds;
    UnknownKeys unknown = {};
    bool operator==(const FloatingPhoto&) const = default;
};

inline constexpr std::size_t mostFloatingPhotos = 60;
inline constexpr double longestWatch = 1e6;               // s
inline constexpr double leastRuler = 90, mostRuler = 110; // mm, measured on a ruler of 100 mm
inline constexpr double mostRulerError = 5;               // mm
inline constexpr double mostCardAbove = 200;              // mm above or below the film
inline constexpr double leastFocal = 5, mostFocal = 2000; // mm, 35 mm equivalent

struct FilmOnWater {
    std::vector<FloatingPhoto> photos;
    std::optional<Seconds> dipBegins; // after the film was laid; none: as in the film profile
    QString lot;
    std::optional<double> waterTemperature; // °C
    // Measured lengths of the two printed 100 mm rulers (across and down), on the card and on the
    // dry film. `rulerError` is their reading error (95 %).
    std::array<Millimetres, 2> cardRulers{Millimetres(100), Millimetres(100)};
    std::array<Millimetres, 2> filmRulers{Millimetres(100), Millimetres(100)};
    Millimetres rulerError{0};
    Millimetres cardAbove{0};             // height of the card's print above the film
    std::optional<Millimetres> focalAs35; // 35 mm equivalent; none: as stored in the photos
    // The lens's distortion, if it was measured before. None: it is fitted for each photo.
    std::optional<double> lensK1, lensK2;
    bool operator==(const FilmOnWater&) const = default;
};

} // namespace dipwright

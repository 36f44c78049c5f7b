// Photos of a film on the water, and what was measured beside them, as in the project file's
// "inspection.film".
#pragma once

#include "base/Units.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace dipwright {

struct FloatingPhoto {
    QString file;                  // which the project does not contain
    QString sha256;                // of the file, hex; empty: it was never read
    std::optional<double> seconds; // since the film was laid; none: when the dip begins
    bool operator==(const FloatingPhoto&) const = default;
};

inline constexpr std::size_t mostFloatingPhotos = 60;
inline constexpr double longestWatch = 1e6;               // s
inline constexpr double leastRuler = 90, mostRuler = 110; // mm, of 100
inline constexpr double mostRulerError = 5;               // mm
inline constexpr double mostCardAbove = 200;              // mm, to either side
inline constexpr double leastFocal = 5, mostFocal = 2000; // mm, as of a 35 mm camera

struct FilmOnWater {
    std::vector<FloatingPhoto> photos;
    std::optional<double> dipBegins; // s; none: as the film's profile has it
    QString lot;
    std::optional<double> waterTemperature; // °C
    // What the two rulers of 100 mm measure, across and down, on the card and on the dry film, and
    // how exactly they were read (95 %).
    std::array<Millimetres, 2> cardRulers{Millimetres(100), Millimetres(100)};
    std::array<Millimetres, 2> filmRulers{Millimetres(100), Millimetres(100)};
    Millimetres rulerError{0};
    Millimetres cardAbove{0};             // the card's print over the film
    std::optional<Millimetres> focalAs35; // as of a 35 mm camera; none: as the photos say
    std::optional<double> lensK1, lensK2; // of a camera measured before; none: as each photo has it
    bool operator==(const FilmOnWater&) const = default;
};

} // namespace dipwright

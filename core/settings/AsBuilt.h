// How the parts of a job came out that were dipped so far, as in the project file's "as_built".
#pragma once

#include "base/Units.h"

#include <QString>
#include <array>
#include <vector>

namespace dipwright {

struct BuiltPart {
    QString date;        // ISO, of the photos
    QString acceptedBy;  // who has said that its figures may count
    QString photos;      // their files' SHA-256, hexadecimal, a space between
    double residual = 0; // mm on the sheet that its places were off, rms
    bool operator==(const BuiltPart&) const = default;
};

// A place of a part's sheet, and where on the sheet the film was printed that is meant to lie where
// it has come to lie.
struct BuiltPlace {
    int part = 1;                       // from 1, of AsBuilt::parts
    int dip = 1;                        // from 1, of the project's immersions
    std::array<Millimetres, 2> sheet{}; // as restPosition() (DippedFilm.h) over the swell
    std::array<Millimetres, 3> model{}; // where it was meant to be: the same place in other parts
    std::array<Millimetres, 2> off{};   // on the sheet, from `sheet`
    bool operator==(const BuiltPlace&) const = default;
};

inline constexpr std::size_t mostBuiltParts = 50;
inline constexpr std::size_t mostBuiltPlaces = 5000;

struct AsBuilt {
    bool corrects = false; // whether the sheets are corrected by what repeats
    double strength = 1;   // share of it
    std::vector<BuiltPart> parts;
    std::vector<BuiltPlace> places;
    bool operator==(const AsBuilt&) const = default;
};

} // namespace dipwright

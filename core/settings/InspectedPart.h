// Photos of a dipped part and the places that the user identified in them, as in the project file's
// "inspection".
#pragma once

#include "base/Units.h"
#include "settings/UnknownKeys.h"

#include <QString>

#include <array>
#include <cstddef>
#include <vector>

namespace dipwright {

struct InspectedPhoto {
    QString file;   // path; the project does not contain the file
    QString sha256; // of the file, hexadecimal; empty: it was never read
    UnknownKeys unknown = {};
    bool operator==(const InspectedPhoto&) const = default;
};

// A pixel of a photo, and the place on the model that it shows.
struct ClickedPair {
    int photo = 0;                      // index of the photo
    std::array<double, 2> pixel{};      // from the picture's upper left corner
    std::array<Millimetres, 3> place{}; // model coordinates
    UnknownKeys unknown = {};
    bool operator==(const ClickedPair&) const = default;
};

inline constexpr std::size_t mostInspectedPhotos = 50;
inline constexpr std::size_t mostClickedPairs = 1000;

struct InspectedPart {
    std::vector<InspectedPhoto> photos;
    std::vector<ClickedPair> pairs;
    bool chessboard = false; // the part was dipped with the job's chessboard instead of its texture
    bool keepsCamera = false; // the pairs are features of the body itself and fix the camera
    bool operator==(const InspectedPart&) const = default;
};

} // namespace dipwright

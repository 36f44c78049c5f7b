// The user's settings for how two dips share a body, as in the project file's "share".
#pragma once

#include "settings/SurfaceMark.h"
#include "settings/UnknownKeys.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// The kinds of marks that the user paints on the body to say where the seam may run.
enum class ShareMarkKind : std::uint8_t {
    First,  // dip 1 paints this
    Second, // dip 2 paints this
    Avoid,  // the seam avoids this area if it can
    Allow,  // the seam may run here
    None,   // takes the area out of earlier marks
};

// A round spot on the body, the whole face at a place, or a brush stroke.
struct ShareMark {
    ShareMarkKind kind = ShareMarkKind::Avoid;
    std::array<Millimetres, 3> place{}; // marks the model's point nearest to it; model coordinates
    Millimetres radius{5};              // along the surface; 0: the whole face
    BrushPath path = {};                // of a stroke; empty: a spot or a face
    UnknownKeys unknown = {};
    bool operator==(const ShareMark&) const = default;
};

inline constexpr std::size_t mostShareMarks = 1000;

struct ShareSettings {
    // Whether each dip paints only its share. If not, each paints everything that it reaches, and
    // the common area is painted twice.
    bool enabled = true;
    Millimetres overlap{1.5}; // least width of the overlap along the seam, in which both dips fade
    Millimetres registrationError{0.7}; // expected position error of dip 2 relative to dip 1
    double stretchLimit = 3;            // length stretch above which the other dip should paint
    std::vector<ShareMark> marks;       // later marks override earlier ones
    bool operator==(const ShareSettings&) const = default;
};

} // namespace dipwright

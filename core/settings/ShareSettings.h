// What the user says of how two dips share a body, as in the project file's "share".
#pragma once

#include "base/Units.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// What the user has painted on the body to say where the join may run.
enum class ShareMarkKind : std::uint8_t {
    First,  // painted by the first dip
    Second, // by the second
    Avoid,  // no join here, if there is another way
    Allow,  // a join does no harm here
};

// A round spot on the body, or the face that it lies on.
struct ShareMark {
    ShareMarkKind kind = ShareMarkKind::Avoid;
    std::array<Millimetres, 3> place{}; // the point of the model nearest to this; model coordinates
    Millimetres radius{5};              // along the surface; 0: the face round the place
    bool operator==(const ShareMark&) const = default;
};

inline constexpr std::size_t mostShareMarks = 1000;

struct ShareSettings {
    // Whether each dip paints its share only. If not, each paints all that it reaches, and what
    // both reach is painted twice.
    bool enabled = true;
    Millimetres overlap{1.5};           // the band along the join where both fade, at least
    Millimetres registrationError{0.7}; // of the second dip against the first, to be prepared for
    double stretchLimit = 3;            // length stretch past which the other dip is to paint
    std::vector<ShareMark> marks;       // later ones count over earlier ones
    bool operator==(const ShareSettings&) const = default;
};

} // namespace dipwright

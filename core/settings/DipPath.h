// How the part moves through the water in one dip, as in the project file's "immersions[i].path".
// dip/BodyPath.h turns it into poses over time.
//
// The rotation of an immersion is the part's rotation at the end of the dip, and its offset is the
// place of the part's centre when the dip begins.
#pragma once

#include "base/Units.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dipwright {

enum class PathKind : std::uint8_t {
    Straight, // straight down
    Slanted,  // down and sideways, in its final rotation
    Tilt,     // enters tilted, with one side first, and is levelled while it goes down
    Roll,     // straight down to the depth of the dip, then rolls sideways over the film
    Poses,    // through poses that the user sets
};

// The limits of the poses of a path.
inline constexpr std::size_t mostPathKeys = 100;
inline constexpr Seconds latestPathKey(10'000);
inline constexpr Seconds leastPathWait(0.01);       // between two poses
inline constexpr Millimetres farthestPathKey(5000); // depth, and way along X or Z
inline constexpr Degrees mostPathTurn(720);         // about each axis

// A pose that the part takes on its way (PathKind::Poses). Between two of them it moves smoothly.
struct PathKey {
    Seconds time{0}; // since the dip began
    // Depth of the lowest point below the water; without a value, the depth of the dip.
    std::optional<Millimetres> depth = Millimetres(0);
    std::array<Millimetres, 2> beside{}; // from the offset of the immersion, X and Z
    // About X, Y, Z, applied in that order after the rotation of the immersion.
    std::array<Degrees, 3> turn{};

    bool operator==(const PathKey&) const = default;
};

struct DipPath {
    PathKind kind = PathKind::Straight;
    // The direction on the water in which the part travels or rolls, or the side that enters first.
    // 0°: +X, to the right; 90°: +Z, down the sheet.
    Degrees heading{0};
    // Slanted: the angle between the path and the water. Tilt: the tilt when the dip begins. Roll:
    // the angle through which the part rolls.
    Degrees angle{45};
    // Tilt: depth of the lowest point at which the part is level; none: at the end of the dip.
    std::optional<Millimetres> levelDepth;
    // Roll: sideways travel for each radian; none: half the part's height, so that a cylinder rolls
    // without slip.
    std::optional<Millimetres> rollRadius;
    // Poses: in the order of time, the first at 0 s and 0 mm, the last at the depth of the dip and
    // without a turn.
    std::vector<PathKey> keys = {};
    // Any kind but Poses: turn about the vertical while the part goes down, counterclockwise seen
    // from above.
    Degrees turn{0};
    // Any kind: speed of the water and the film with it, in the direction of the heading. The film
    // sees the part travel the other way.
    MillimetresPerSecond waterSpeed{0};
    // Any kind but Poses: speed over the first and the last `slowWay` of the way down; none: the
    // speed of the dip.
    std::optional<MillimetresPerSecond> slowSpeed;
    Millimetres slowWay{5};
    // Any kind: the acceleration, mm/s², with which the part reaches its speed and stops; none: at
    // once. The part moves no faster than without it, so that the dip takes longer.
    std::optional<MillimetresPerSecondSquared> acceleration;

    bool operator==(const DipPath&) const = default;

    // Whether the first and the last part of the way down have the slow speed.
    bool isSlowed() const {
        return kind != PathKind::Poses && slowSpeed && slowWay > Millimetres(0);
    }

    // Whether the part goes straight down at one speed, in its final rotation.
    bool isStraightDown() const {
        return kind == PathKind::Straight && turn == Degrees(0) &&
               waterSpeed == MillimetresPerSecond(0) && !slowSpeed && !acceleration;
    }
};

} // namespace dipwright

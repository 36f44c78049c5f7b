// The user's settings for tolerances and zones: how exactly a job can be carried out, and how exact
// it has to be. As in the project file's "tolerance".
#pragma once

#include "settings/SurfaceMark.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// The zones of a body. They differ in how exactly they must be painted. Unmarked surface belongs to
// the last zone.
enum class Zone : std::uint8_t { A, B, C };
inline constexpr std::size_t zoneCount = 3;

struct ZoneMark : SurfaceMark {
    Zone zone = Zone::A;
    bool operator==(const ZoneMark&) const = default;
};

inline constexpr std::size_t mostZoneMarks = 1000;

// Tolerances are ± values; 0 means exact. Each is two standard deviations: 95 % of the dips are
// within it. They are independent of each other (docs/film-model.md, "Tolerances").
struct ToleranceSettings {
    std::array<Millimetres, 2> position{Millimetres(0.3), Millimetres(0.3)}; // body, along X and Z
    std::array<Degrees, 3> turn{Degrees(0.3), Degrees(0.3), Degrees(0.3)};   // body, about X, Y, Z
    std::array<Millimetres, 2> filmPosition{Millimetres(0.5), Millimetres(0.5)}; // along X and Z
    Degrees filmTurn{0.3};     // rotation of the film on the water
    double swell = 0.005;      // share of the floating film's length
    Millimetres waterLevel{1}; // relative to the tank; changes how deep the body goes under
    double speed = 0.05;       // share of the dip speed
    double relaxation = 0.2;   // share of the relaxation time
    Degrees pathAngle{0.5};    // of the path's angle, if it has one (settings/DipPath.h)
    Seconds timing{0.5};       // of the moment at which the dip begins
    int samples = 24;          // number of simulated dips with all errors at once
    int seed = 1;              // for the random errors of these dips
    std::array<Millimetres, zoneCount> limits{Millimetres(0.3), Millimetres(0.7), Millimetres(1.5)};
    std::vector<ZoneMark> marks; // later marks override earlier ones
    bool operator==(const ToleranceSettings&) const = default;
};

} // namespace dipwright

// What the user says of how exactly a job can be carried out, and how exactly it has to come out,
// as in the project file's "tolerance".
#pragma once

#include "base/Units.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// Parts of the body by how exactly they are to be painted. What is not marked is in the last.
enum class Zone : std::uint8_t { A, B, C };
inline constexpr std::size_t zoneCount = 3;

// How far a mark goes round its place.
enum class ZoneExtent : std::uint8_t {
    Spot,     // a radius along the surface
    Face,     // the face that the place lies on
    Material, // all that has the material of the place
};

struct ZoneMark {
    Zone zone = Zone::A;
    std::array<Millimetres, 3> place{}; // the point of the model nearest to this; model coordinates
    ZoneExtent extent = ZoneExtent::Spot;
    Millimetres radius{5}; // of a spot
    bool operator==(const ZoneMark&) const = default;
};

inline constexpr std::size_t mostZoneMarks = 1000;

// Tolerances are to either side, 0: exact. Two standard deviations each: 95 % of the dips keep
// them, and none has to do with another (docs/film-model.md, "Tolerances").
struct ToleranceSettings {
    std::array<Millimetres, 2> position{Millimetres(0.3), Millimetres(0.3)}; // body, along X and Z
    std::array<Degrees, 3> turn{Degrees(0.3), Degrees(0.3), Degrees(0.3)};   // body, about X, Y, Z
    std::array<Millimetres, 2> filmPosition{Millimetres(0.5), Millimetres(0.5)}; // along X and Z
    Degrees filmTurn{0.3};     // of the film on the water
    double swell = 0.005;      // share of the floating film's length
    Millimetres waterLevel{1}; // against the tank, and so how deep the body goes under
    double speed = 0.05;       // share
    double relaxation = 0.2;   // share of the relaxation time
    int samples = 24;          // dips with everything off at once; 0: none
    int seed = 1;              // of what is off by how much in them
    std::array<Millimetres, zoneCount> limits{Millimetres(0.3), Millimetres(0.7), Millimetres(1.5)};
    std::vector<ZoneMark> marks; // later ones count over earlier ones
    bool operator==(const ToleranceSettings&) const = default;
};

} // namespace dipwright

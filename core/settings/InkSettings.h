// The user's settings for ink on stretched film, as in the project file's "ink", and the measured
// law by which it thins there (texture/InkLaw.h).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace dipwright {

// Inks: three named by the light that they absorb (red, green, blue); black; and white, which
// hides.
enum class FilmInk { Cyan, Magenta, Yellow, Black, White };
inline constexpr int inkCount = 5;
inline constexpr int lightInks = 3; // the first three, which RGB pictures can describe

// One measured patch of a step wedge: for ink printed with `density`, n = exponent + bend·ln J.
// Beyond `mostStretch` n stays as it is there. For white the density is the share that it hides, 0
// … 1.
struct InkTone {
    FilmInk ink = FilmInk::Cyan;
    double density = 0;
    double exponent = 1;
    double bend = 0;
    double mostStretch = 1; // J
    bool operator==(const InkTone&) const = default;
};
inline constexpr int mostInkTones = 150;
inline constexpr double leastToneDensity = 0.005, mostToneDensity = 4;
// dye has 1; dots that hide everything behind them have 0
inline constexpr double mostInkExponent = 2;
inline constexpr double mostInkBend = 2;
inline constexpr double mostWedgeStretch = 20;

struct InkLaw {
    std::array<double, inkCount> exponents{1, 1, 1, 1, 1}; // for inks without tones
    // By ink, then by density. Between two tones n is linear in the logarithm of the density;
    // outside them it is that of the nearest tone.
    std::vector<InkTone> tones;
    bool operator==(const InkLaw&) const = default;
};

struct InkSettings {
    // print the ink that gives the wanted density after the film has stretched by J
    bool compensate = true;
    // The highest optical density per channel that compensation may reach. A colour that is denser
    // by itself is printed unchanged.
    double limit = 2.0;
    InkLaw law = {}; // for the ink on the film
    // Whether each ink is compensated separately, after separation: true if the law is known to
    // differ from that of dyes.
    bool isPerInk() const { return compensate && law != InkLaw(); }
    bool operator==(const InkSettings&) const = default;
};

} // namespace dipwright

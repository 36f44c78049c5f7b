// What the user says of ink on stretched film, as in the project file's "ink", and what is known of
// how it thins there (texture/InkLaw.h).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace dipwright {

// Inks: three by the light that they take away, red, green, blue; black; white, which hides.
enum class FilmInk { Cyan, Magenta, Yellow, Black, White };
inline constexpr int inkCount = 5;
inline constexpr int lightInks = 3; // the first of them, which pictures in RGB know

// What one patch of a step wedge told: n = exponent + bend·ln J for what is printed with `density`,
// and as at `mostStretch` beyond it. Of white the density is the share that it hides, 0 … 1.
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
inline constexpr double mostInkExponent = 2; // dye has 1, dots that hide all behind them 0
inline constexpr double mostInkBend = 2;
inline constexpr double mostWedgeStretch = 20;

struct InkLaw {
    std::array<double, inkCount> exponents{1, 1, 1, 1, 1}; // of inks without tones
    // Of each ink in the order of their density; between two of them n is linear in the density's
    // logarithm, outside it is the last one's.
    std::vector<InkTone> tones;
    bool operator==(const InkLaw&) const = default;
};

struct InkSettings {
    bool compensate = true; // print what shows D after the film has stretched by J
    // The highest optical density, a channel, up to which compensation goes. Colour that is denser
    // than this by itself is printed as it is.
    double limit = 2.0;
    InkLaw law = {}; // of the ink on the film
    // Whether a printer of inks is to get each compensated by itself, after separation: where more
    // is known of them than that they might be dyes.
    bool isPerInk() const { return compensate && law != InkLaw(); }
    bool operator==(const InkSettings&) const = default;
};

} // namespace dipwright

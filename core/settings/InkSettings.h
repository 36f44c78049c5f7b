// The user's settings for ink on stretched film, as in the project file's "ink". They include the
// measured law of how ink thins there (texture/InkLaw.h).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace dipwright {

// The inks on a film. Cyan, magenta and yellow absorb red, green and blue light. White hides what
// lies behind it.
enum class FilmInk { Cyan, Magenta, Yellow, Black, White };
inline constexpr int inkCount = 5;
inline constexpr int lightInks = 3; // the first three, which RGB pictures can describe

// One measured patch of a step wedge. On film stretched to J times its area, ink printed with
// `density` thins with the exponent n = exponent + bend·ln J. Above `mostStretch`, n stays
// constant. For white, the density is the share that the ink hides, 0 … 1.
struct InkTone {
    FilmInk ink = FilmInk::Cyan;
    double density = 0;
    double exponent = 1;
    double bend = 0;
    double mostStretch = 1; // largest measured J
    bool operator==(const InkTone&) const = default;
};
inline constexpr int mostInkTones = 150;
inline constexpr double leastToneDensity = 0.005, mostToneDensity = 4;
// largest exponent n; dye has 1, opaque dots have 0
inline constexpr double mostInkExponent = 2;
inline constexpr double mostInkBend = 2;
inline constexpr double mostWedgeStretch = 20;

struct InkLaw {
    std::array<double, inkCount> exponents{1, 1, 1, 1, 1}; // n of inks without tones
    // Sorted by ink, then by density. Between two tones, n is linear in the logarithm of the
    // density. Below the first and above the last tone, n is constant.
    std::vector<InkTone> tones;
    bool operator==(const InkLaw&) const = default;
};

inline constexpr double leastLightening = 10; // a density that no texture exceeds in print
inline constexpr int mostInkPasses = 4;

struct InkSettings {
    // Whether the sheet is printed with the ink that gives the wanted density on the stretched
    // film.
    bool compensate = true;
    // The highest optical density per channel that compensation may reach. A colour whose own
    // density is higher is printed unchanged.
    double limit = 2.0;
    InkLaw law = {}; // how the ink thins on the film
    // The optical density to which a tone curve lightens the densest colours of the texture
    // (texture/ToneCurve.h). At the ink limit or above it, the texture stays as it is.
    double densest = leastLightening;
    // How many times each sheet is to be printed onto the same film. Every pass prints an equal
    // share of the ink, so that the ink limit holds for each pass.
    int passes = 1;
    // Whether each ink is compensated separately, after separation: true if the law is known to
    // differ from that of dyes.
    bool isPerInk() const { return compensate && law != InkLaw(); }
    // How many times a sheet with these settings is printed. A picture that is not compensated has
    // the ink of a single pass.
    int printedPasses() const { return compensate ? passes : 1; }
    bool operator==(const InkSettings&) const = default;
};

} // namespace dipwright

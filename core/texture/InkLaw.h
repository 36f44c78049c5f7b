// How ink thins on film that stretches (docs/film-model.md, "Ink").
//
// An even layer, as of a dye, keeps Beer–Lambert: where the film's area has grown by J the printed
// density P shows as P/J. Dots that stretch with the film cover as much of it as before and show
// more; how much more hangs on how dense they are. So the law is P·J^−n, with an n for each ink,
// and where a step wedge was read, for each of its tones.
#pragma once

#include <QString>
#include <array>
#include <span>
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

// Throws Error where an ink's tones are not ascending, or more of it would show less.
void checkInkLaw(const InkLaw& law, const QString& where);

// A patch of a step wedge, read before the film was stretched and after.
struct WedgeReading {
    FilmInk ink = FilmInk::Cyan;
    double nominal = 0; // density that the page asked for
    double flat = 0;    // density that unstretched film shows
    double stretch = 1; // J, above 1
    double shown = 0;   // density
};

struct FittedInk {
    InkLaw law;
    int patches = 0;
    double worst = 0; // of density: the farthest that a reading is from the law
};
// A tone for each patch by least squares over its stretches; inks that were not read keep the
// exponent 1. Throws Error, with `where`, on readings that no ink gives, and on too few.
FittedInk fitInk(std::span<const WedgeReading> readings, const QString& where);

} // namespace dipwright

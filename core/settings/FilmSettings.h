// What the user says of the film, as in the project file's "film".
#pragma once

#include "base/Units.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <limits>
#include <vector>

namespace dipwright {

// Which sides of the film are held by barriers; left is −X, top is −Z (the top of the sheet).
struct FilmEdges {
    bool leftPinned = false;
    bool rightPinned = false;
    bool topPinned = false;
    bool bottomPinned = false;
    bool operator==(const FilmEdges&) const = default;
};

// What a film does on the water and on the body: a part of a project's film and of a film profile.
// Its fields are declared in project/FilmFields.cpp.
struct FilmBehaviour {
    FilmEdges edges;
    double swellX = 1; // wetted length over printed length
    double swellY = 1; // along the sheet's height, the film's Z
    Seconds relaxationTime{
        std::numeric_limits<double>::infinity()}; // infinity: elastic, 0: viscous
    Millimetres contactDistance{0};
    // What it does besides, production film only (docs/film-model.md, "Constants of ours"; for the
    // overhang and the tear see ProcessSettings).
    double growthRate = 0;         // of its length, 1/s: how fast it grows while it floats …
    double growthLimit = 0;        // … and by how much in the end, a share of its length
    Degrees gripFade{5};           // before the overhang: from there on it is held ever less
    double gatheringStretch = 0.8; // mean stretch below which it gathers

    bool operator==(const FilmBehaviour&) const = default;
    FilmBehaviour& behaviour() { return *this; }
    const FilmBehaviour& behaviour() const { return *this; }
};

inline constexpr int maximumFilmGrid = 4'000'000; // points that a film may have

// How many points a film has.
enum class FilmResolution : std::uint8_t {
    Points,    // columns × rows, evenly spaced
    Automatic, // as many as the body in its pose needs, graded (dip/FilmUnderBody.h)
    Cell,      // graded, with cells of a given size over the body
};

// The defaults of every film; the solver interface's own, some of which differ, count for no job,
// as in ProcessSettings.
struct FilmSettings : FilmBehaviour {
    QString preset = QStringLiteral("A4");
    Millimetres width{210};  // the printed sheet along X
    Millimetres height{297}; // the printed sheet along Z
    FilmResolution resolution = FilmResolution::Points;
    int columns = 120;     // FilmResolution::Points, and always of the paper's film
    int rows = 170;        // as are these
    Millimetres cell{1};   // FilmResolution::Cell: over the body, of the floating film
    double refinement = 1; // so many times as many cells along both edges; not the user's
    solver::Lattice lattice = solver::Lattice::Isotropic;
    solver::Support support = solver::Support::Water;
    bool operator==(const FilmSettings&) const = default;
};

} // namespace dipwright

// The user's settings for the film, as in the project file's "film".
#pragma once

#include "base/Units.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <limits>
#include <optional>
#include <vector>

namespace dipwright {

// The sides of the film that barriers hold. Left is −X, top is −Z (the top of the sheet).
struct FilmEdges {
    bool leftPinned = false;
    bool rightPinned = false;
    bool topPinned = false;
    bool bottomPinned = false;
    bool operator==(const FilmEdges&) const = default;
};

// How a film behaves on the water and on the body. Part of a project's film and of a film profile.
// Its fields are declared in project/FilmFields.cpp.
struct FilmBehaviour {
    FilmEdges edges;
    double swellX = 1; // wetted length divided by printed length, along the film's X
    double swellY = 1; // the same along the sheet's height, the film's Z
    Seconds relaxationTime{
        std::numeric_limits<double>::infinity()}; // infinity: elastic, 0: viscous
    Millimetres contactDistance{0};
    // The values below are for the production film only (docs/film-model.md, "Assumed constants").
    // ProcessSettings holds the overhang and the tear limit.
    double growthRate = 0;  // relative growth rate of the floating film's length, 1/s
    double growthLimit = 0; // total relative growth of the floating film's length after a long time
    Degrees gripFade{5};    // range before the overhang in which the grip fades
    double gatheringStretch = 0.8; // mean stretch below which film gathers

    bool operator==(const FilmBehaviour&) const = default;
    FilmBehaviour& behaviour() { return *this; }
    const FilmBehaviour& behaviour() const { return *this; }
};

// Whether floating film grows with these values.
inline bool grows(const FilmBehaviour& film) {
    return film.growthRate > 0 && film.growthLimit > 0;
}

inline constexpr int maximumFilmGrid = 4'000'000; // most points of a film
inline constexpr double leastFilmCell = 0.1;      // mm: smallest FilmSettings::cell
inline constexpr double defaultFilmWork = 60;     // FilmSettings::work of a file that has none
inline constexpr double mostFilmWork = 100'000;

// How the number of a film's points is chosen.
enum class FilmResolution : std::uint8_t {
    Points,    // columns × rows, evenly spaced
    Automatic, // as many as the body in its pose needs, graded (dip/FilmUnderBody.h)
    Cell,      // graded, with cells of a given size over the body
};

// The defaults of every film. Some defaults of the solver interface differ; no job uses them (see
// ProcessSettings).
struct FilmSettings : FilmBehaviour {
    QString preset = QStringLiteral("A4");
    Millimetres width{210};  // the printed sheet along X
    Millimetres height{297}; // the printed sheet along Z
    FilmResolution resolution = FilmResolution::Points;
    int columns = 120;   // for FilmResolution::Points, and always for the film of the 2020 paper
    int rows = 170;      // see `columns`
    Millimetres cell{1}; // for FilmResolution::Cell: cell size of the floating film over the body
    // For FilmResolution::Automatic: the dip is repeated with smaller cells until its sheet can be
    // printed, but never with more than this expected work: million points × steps. 0: never
    // repeated.
    double work = defaultFilmWork;
    // The dip is also repeated until 95 % of the painted area is off by at most this, within the
    // same limit. None: only until the sheet can be printed.
    std::optional<Millimetres> wantedError;
    double refinement = 1; // multiplies the number of cells along both edges; not set by the user
    solver::Lattice lattice = solver::Lattice::Isotropic;
    solver::Support support = solver::Support::Water;
    bool operator==(const FilmSettings&) const = default;
};

} // namespace dipwright

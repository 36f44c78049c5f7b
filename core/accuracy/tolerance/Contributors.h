// What may be off in a dip, each by its own tolerance, and what that does to it.
#pragma once

#include "model/TexturedMesh.h"
#include "settings/Immersion.h"
#include "settings/ToleranceSettings.h"

#include <dipwright/FilmSolver.h>

#include <Eigen/Core>
#include <QString>

namespace dipwright {

struct TexturedMesh;

enum class Contributor : std::uint8_t {
    PositionX,
    PositionZ,
    TurnX,
    TurnY,
    TurnZ,
    FilmPositionX,
    FilmPositionZ,
    FilmTurn,
    Swell,
    WaterLevel,
    Speed,
    Relaxation,
};
inline constexpr std::size_t contributorCount = 12;
inline constexpr Contributor contributorAt(std::size_t number) {
    return Contributor(number);
}

// In its own unit: mm, degrees or per cent.
double toleranceOf(const ToleranceSettings& settings, Contributor contributor);
// For the user: "Body along X", "mm".
QString contributorText(Contributor contributor);
QString contributorUnit(Contributor contributor);
// For files: "position_x".
QString contributorKey(Contributor contributor);

// The ways in which a dip can be another one. Film that lies off its place is no way of its own:
// nothing holds it but itself, so it is the body that lies off it the other way round.
enum class Freedom : std::uint8_t {
    X, // of the body against the film, mm
    Z,
    TurnX, // of the body about the centre of its bounding box, about fixed axes; degrees
    TurnY,
    TurnZ,
    Swell,      // share of the film's length
    WaterLevel, // mm that the body goes deeper
    Speed,      // share
    Relaxation, // share
};
inline constexpr std::size_t freedomCount = 9;
// How far a dip is off, a Freedom each.
using DipChange = Eigen::Matrix<double, int(freedomCount), 1>;
inline double& of(DipChange& change, Freedom freedom) {
    return change[int(freedom)];
}
inline double of(const DipChange& change, Freedom freedom) {
    return change[int(freedom)];
}

// What being off by one of its unit makes of a dip. Linear: turns are small. The film turns about
// its own middle, and so the body, which may stand beside that, moves as well.
DipChange changeBy(Contributor contributor, const Immersion& immersion);

// What a dip is, and on which film.
struct NominalDip {
    const TexturedMesh& model; // as imported, mm
    const Immersion& immersion;
    const solver::DipSetup& setup; // that it was done with
};

// A dip that is off.
struct ChangedDip {
    Immersion immersion;    // in which the film is on the body
    solver::DipSetup setup; // on the same film points
};
ChangedDip changed(const NominalDip& dip, const DipChange& change);

// Whether it changes a dip at all if this is off.
bool matters(Freedom freedom, const solver::Settings& settings);

} // namespace dipwright

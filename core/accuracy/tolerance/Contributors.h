// Names the quantities that may deviate in a dip, their tolerances, and what each does to the dip.
#pragma once

#include "model/TexturedMesh.h"
#include "settings/Immersion.h"
#include "settings/ProcessSettings.h"
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
    PathAngle,
    Timing,
};
inline constexpr std::size_t contributorCount = 14;
inline constexpr Contributor contributorAt(std::size_t number) {
    return Contributor(number);
}

// Returns the tolerance in the contributor's unit: mm, degrees, per cent or s.
double toleranceOf(const ToleranceSettings& settings, Contributor contributor);
// Return the name and the unit for the user: "Position of the part along X", "mm".
QString contributorText(Contributor contributor);
QString contributorUnit(Contributor contributor);
// Returns the key for files: "position_x".
QString contributorKey(Contributor contributor);

// The independent ways in which a dip can deviate. A displaced film is not a separate way: it has
// the same effect as a body displaced in the opposite direction. A turned film is one on a path
// only: the whole path then turns about the film's centre in the opposite direction.
enum class Freedom : std::uint8_t {
    X, // position of the body relative to the film along X, mm
    Z,
    TurnX, // rotation of the body about the centre of its bounding box, fixed axes, degrees
    TurnY,
    TurnZ,
    Swell,      // growth as a fraction of the film's length
    WaterLevel, // additional depth of the dip, mm
    Speed,      // change as a fraction of the speed
    Relaxation, // change as a fraction of the relaxation time
    PathAngle,  // change of the path's angle (settings/DipPath.h), degrees
    Growth,     // how much longer the film has grown before the dip begins, s
    FilmTurn,   // rotation of the film about the vertical through its centre, degrees; on a path
};
inline constexpr std::size_t freedomCount = 12;
// The deviation of a dip, one value for each Freedom.
using DipChange = Eigen::Matrix<double, int(freedomCount), 1>;
inline double& of(DipChange& change, Freedom freedom) {
    return change[int(freedom)];
}
inline double of(const DipChange& change, Freedom freedom) {
    return change[int(freedom)];
}

// Returns the deviation caused by one unit of a contributor. Linear, because turns are small. The
// film turns about its own centre; in a straight dip, a body away from that centre therefore also
// changes its position. If the dip begins late, the water has carried the film on.
DipChange changeBy(Contributor contributor, const Immersion& immersion);

// A dip as planned, and its film.
struct NominalDip {
    const TexturedMesh& model; // imported model, mm
    const Immersion& immersion;
    const solver::DipSetup& setup; // setup of the dip's simulation
    const ProcessSettings& process;
};

// A dip that deviates from the nominal one.
struct ChangedDip {
    Immersion immersion;    // pose in which the dip's film lies on the body
    solver::DipSetup setup; // setup with the same film points as the nominal dip
    double filmLength = 1;  // of the film when the dip begins, relative to the nominal film
};
// Applies a deviation to a dip. Throws Error if the path cannot be travelled with its changed
// angle.
ChangedDip changed(const NominalDip& dip, const DipChange& change);

// Tells whether a deviation of this kind has any effect on a dip.
bool matters(Freedom freedom, const solver::Settings& settings, const DipPath& path);
// Tells whether a contributor is listed for a dip: the angle of a path if the path has one, the
// timing if it has an effect, and all others.
bool isListed(Contributor contributor, const solver::Settings& settings, const DipPath& path);

} // namespace dipwright

// The user's settings for the dipping process, as in the project file's "process".
#pragma once

#include "base/Units.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <optional>

namespace dipwright {

// The defaults of every dip. dipSetup() (Dip.h) passes every value to the solver. Some defaults of
// the solver interface differ; no job uses them.
struct ProcessSettings {
    MillimetresPerSecond dipSpeed{5};
    Seconds timeStep{1.0 / 60}; // paper-2020 only; the production film chooses its own step
    int iterations = 5;         // paper-2020 only
    solver::Relaxation relaxation = solver::Relaxation::Jacobi; // paper-2020 only
    bool selfContact = false;                                   // paper-2020 only
    // production only: how far the contact line moves in one step, in cells
    double contactTravel = 0.25; // new projects: newProjectContactTravel (NewProject.h)
    // depth of the lowest point under water; none: the whole body goes under
    std::optional<Millimetres> depth;
    Millimetres margin{2};  // extra depth after the whole body is under water
    double tearStretch = 4; // length or area stretch above which film tears
    Degrees overhang{20};   // a face that turns up by more than this holds no film
    QString solver = QStringLiteral("auto");
    bool operator==(const ProcessSettings&) const = default;
};

} // namespace dipwright

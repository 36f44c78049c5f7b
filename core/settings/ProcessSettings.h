// What the user says of the dip itself, as in the project file's "process".
#pragma once

#include "base/Units.h"

#include <dipwright/FilmSolver.h>

#include <QString>
#include <optional>

namespace dipwright {

// The defaults of every dip: dipSetup() (Dip.h) always hands the solver each value of these
// that it asks for, so the solver interface's own defaults, some of which differ, count for no job.
struct ProcessSettings {
    MillimetresPerSecond dipSpeed{5};
    Seconds timeStep{1.0 / 60}; // paper-2020 only; the production film chooses its own step
    int iterations = 5;         // paper-2020 only
    solver::Relaxation relaxation = solver::Relaxation::Jacobi; // paper-2020 only
    bool selfContact = false;                                   // paper-2020 only
    double contactTravel = 0.25;      // production only: cells the contact line travels in one step
    std::optional<Millimetres> depth; // how far the lowest point goes under; none: all of the body
    Millimetres margin{2};            // farther than fully under
    double tearStretch = 4;           // length or area stretch past which film is torn
    Degrees overhang{20};             // film holds on faces that turn upwards by no more than this
    QString solver = QStringLiteral("auto");
    bool operator==(const ProcessSettings&) const = default;
};

} // namespace dipwright

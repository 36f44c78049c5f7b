// Compares films simulated by the user's own solver with closed forms, as evidence that the sheets
// are right.
#pragma once

#include "base/Progress.h"
#include "validation/ClosedForm.h"

#include <dipwright/FilmSolver.h>

#include <QImage>
#include <QJsonObject>
#include <QString>
#include <functional>
#include <vector>

namespace dipwright {

// One comparison. For bodies of revolution, an error is the relative deviation of the film radius
// from the closed form. For other bodies it is a distance in mm.
struct PhysicsResult {
    QString body;  // "Cone of 30°"
    QString film;  // "elastic", "viscous, free, growing"
    int cells = 0; // film cells in the contact radius
    bool inMillimetres = false;
    double rms = 0, mean = 0, maximum = 0; // errors as fractions, or in mm
    double anisotropy = 0; // mean error along the grid's axes minus along its diagonals
    double allowed = 0;    // largest allowed `rms`
    std::int64_t steps = 0;
    double seconds = 0;
    struct Sample {
        double arc, simulated, exact; // mm
    };
    std::vector<Sample> samples; // a selection for the plot
    bool passed() const { return rms <= allowed; }
};

struct PhysicsOptions {
    std::vector<int> resolutions{15, 30, 60}; // film cells in the contact radius
    double contactTravel = 0;                 // cells per step; 0: the solver's default
    int threads = 0;
    // Selects bodies of revolution, films and resolutions; empty: all.
    std::function<bool(const QString& body, const QString& film, int cells)> isWanted;
};

// Compares spheres up to 80° from their lowest point, spheroids, cones and the inside of a torus at
// every resolution, in elastic and viscous film and some in growing film. Then compares a flat
// face, a horizontal cylinder, film that only grows, and a body turned by 45°. Throws Error or
// Cancelled.
std::vector<PhysicsResult> validatePhysics(const solver::SolverModule& module,
                                           const PhysicsOptions& options, const Progress& progress);

QString physicsTable(const std::vector<PhysicsResult>& results); // plain text, aligned
QJsonObject physicsJson(const std::vector<PhysicsResult>& results);
// Plots the film radius over the arc length: exact curves, simulated points and rms errors.
QImage physicsPlot(const std::vector<PhysicsResult>& results, QSize size);

} // namespace dipwright

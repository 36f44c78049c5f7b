// The production film against its closed forms, run by the user on the user's own solver: why to
// believe the sheet.
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

// One comparison. Errors of bodies of revolution are of the film radius, relative to the closed
// form; those of the others are distances in mm.
struct PhysicsResult {
    QString body;  // "Sphere to 80°"
    QString film;  // "elastic", "viscous, free, growing"
    int cells = 0; // in the contact radius
    bool inMillimetres = false;
    double rms = 0, mean = 0, maximum = 0; // shares of 1, or mm
    double anisotropy = 0; // mean error along the grid's axes minus along its diagonals
    double allowed = 0;    // of the rms
    std::int64_t steps = 0;
    double seconds = 0;
    struct Sample {
        double arc, simulated, exact; // mm
    };
    std::vector<Sample> samples; // thinned, for the plot
    bool passed() const { return rms <= allowed; }
};

struct PhysicsOptions {
    std::vector<int> resolutions{15, 30, 60}; // cells in the contact radius
    double contactTravel = 0;                 // of a step, cells; 0: the solver's own
    int threads = 0;
    // Which bodies of revolution are compared, in which film and at which resolution; empty: all.
    std::function<bool(const QString& body, const QString& film, int cells)> isWanted;
};

// Spheres to 80°, spheroids, cones and the inside of a torus, elastic and viscous, some of them in
// film that grows too, at every resolution; then the flat face, the rolling cylinder, film that
// only grows and a body turned by 45°. Throws Error, Cancelled.
std::vector<PhysicsResult> validatePhysics(const solver::SolverModule& module,
                                           const PhysicsOptions& options, const Progress& progress);

QString physicsTable(const std::vector<PhysicsResult>& results); // plain text, aligned
QJsonObject physicsJson(const std::vector<PhysicsResult>& results);
// Film radius over arc length, simulated points on the exact curves, and the errors below.
QImage physicsPlot(const std::vector<PhysicsResult>& results, QSize size);

} // namespace dipwright

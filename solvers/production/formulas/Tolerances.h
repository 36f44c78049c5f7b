// The limits and tolerances of the production film's searches, with their reference values. They
// are the same on all devices.
#pragma once

namespace dipwright::numerics {

// The search for the film's equilibrium (Equilibrium.h). Forces are roots of sums of squares: of
// the remaining forces on free points, and of the elastic forces in the film. The allowed ratio of
// both is a setting, solver::Settings::residual in FilmSolver.h.
struct NewtonLimits {
    int newtonSteps = 24; // at most
    int stepsWithoutGain =
        6;               // gives up after this many steps without reducing the remaining forces by
    double gain = 0.8;   // this factor below the smallest so far
    int shortenings = 6; // of one Newton step, by half each, at most
    double sufficientDecrease = 0.1; // of the remaining forces, times the share of the step taken
    // The residual of a Newton step's linear system: this share of the forces allowed at the end,
    // or that share of the remaining forces, whichever is larger.
    double linearShareOfAllowed = 0.5, linearShareOfLeft = 0.02;
    // Force on a point, relative to the film's shear stiffness times a length. The length is the
    // largest of the farthest displacement from rest, the film's longest edge, and 1 mm. Below this
    // average force, the film is in equilibrium within the precision of the numbers.
    double flatForce = 1e-6;
};

// Stiffening of the film, relative to its shear stiffness, and the factor between two attempts.
inline constexpr double leastStiffening = 0.5, mostStiffening = 8, stiffeningFactor = 4;

// If the film does not converge, points with at least this share of the largest force are held.
// This is repeated at most `mostHolds` times per step.
inline constexpr double unbalancedShare = 0.1;
inline constexpr int mostHolds = 4;

// The largest motion of a point in one Newton step, in units of the longer cell edge.
inline constexpr double longestNewtonStep = 2;
inline constexpr double shortestNewtonStep = 1e-30; // mm: only avoids a division by zero

// The method of least residuals: basis vectors before a restart, and number of restarts.
inline constexpr int mostBasisVectors = 12;
inline constexpr int mostRestarts = 4;

// The time of contact within a step (Adhesion.h): halvings of the step.
inline constexpr int contactTimeHalvings = 24;

// The search for the contact line (ContactPath.h).
inline constexpr int contactLineHalvings = 20;     // between a place in the body and one outside
inline constexpr int contactLineNewtonSteps = 12;  // in the water plane, at most
inline constexpr int acrossLineNewtonSteps = 6;    // along the line's normal, at most
inline constexpr int surfaceNewtonSteps = 3;       // along ∇φ to the surface, at most
inline constexpr double contactLineReached = 1e-4; // remaining distance, in cells
// The component of ∇φ in the water plane (|∇φ| is 1 nearly everywhere). Flatter places have no
// contact line, and a search along the line's normal stops there. The search in the plane may start
// far from the line. It stops where the square of this component is below the second number.
inline constexpr double leastSlope = 0.02, leastPlaneSlopeSquared = 0.0025;
inline constexpr double leastGradientSquared = 0.04; // |∇φ|² below this is a ridge

} // namespace dipwright::numerics

// The limits and tolerances of the production film's searches, the same on all devices.
#pragma once

namespace dipwright::numerics {

// The limits of the search for the film's equilibrium (Equilibrium.h). Forces are measured as roots
// of sums of squares: of the remaining forces on free points, and of the elastic forces in the
// film. The allowed ratio of the two is a setting, solver::Settings::residual in FilmSolver.h.
struct NewtonLimits {
    int newtonSteps = 24; // largest number of Newton steps
    // The search fails after this many steps that do not reduce the smallest forces by `gain`.
    int mostStepsWithoutReduction = 6;
    double gain = 0.8;   // the new forces must be below this factor times the smallest so far
    int shortenings = 6; // at most; each halves the Newton step
    // Required reduction, as a share of the remaining forces per share of the Newton step.
    double sufficientDecrease = 0.1;
    // The linear system of a Newton step is solved to a residual: the first share of the forces
    // allowed at the end, or the second share of the remaining forces, whichever is larger.
    double linearShareOfAllowed = 0.5, linearShareOfRemaining = 0.02;
    // Average force on a point below which the film counts as being in equilibrium, because of the
    // precision of the numbers. It is relative to the film's shear stiffness times a length: the
    // largest of the farthest displacement from rest, the film's longest edge, and 1 mm.
    double flatForce = 1e-6;
};

// Stiffening of the film, relative to its shear stiffness: the smallest and the largest value, and
// the factor from one attempt to the next.
inline constexpr double leastStiffening = 0.5, mostStiffening = 8, stiffeningFactor = 4;

// If the film does not converge, the points whose force is at least this share of the largest force
// are held. This is repeated at most `mostHolds` times per step.
inline constexpr double unbalancedShare = 0.1;
inline constexpr int mostHolds = 4;

// The largest motion of a point in one Newton step, in units of the longer cell edge.
inline constexpr double longestNewtonStep = 2;
inline constexpr double shortestNewtonStep = 1e-30; // mm: only avoids a division by zero

// GMRES: largest number of basis vectors. A search that needs more gains nothing from an exact
// linear solution, because its film folds.
inline constexpr int mostBasisVectors = 12;

// Limits of the search for the contact line (ContactPath.h).
inline constexpr int contactLineNewtonSteps = 12;  // in the water plane, at most
inline constexpr int acrossLineNewtonSteps = 6;    // along the line's normal, at most
inline constexpr double acrossLineFound = 1e-4;    // length of the last step there, in cells
inline constexpr int surfaceNewtonSteps = 3;       // along ∇φ to the surface, at most
inline constexpr double contactLineReached = 1e-4; // remaining distance to the line, in cells
// The component of ∇φ in the water plane (|∇φ| is 1 nearly everywhere). Where it is below the first
// number, the surface is too flat to have a contact line, and a search along the line's normal
// stops. The search in the plane may start far from the line, and stops where the square of this
// component is below the second number.
inline constexpr double leastSlope = 0.02, leastPlaneSlopeSquared = 0.0025;
inline constexpr double leastGradientSquared = 0.04; // |∇φ|² below this is a ridge

} // namespace dipwright::numerics

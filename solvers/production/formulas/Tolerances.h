// The limits and tolerances of the production film's searches, and what each is relative to; the
// same on every device.
#pragma once

namespace dipwright::numerics {

// The search for the film's equilibrium (Equilibrium.h). Forces are roots of sums of squares: those
// left on the free points, and the elastic ones within the film. Which share of the latter may be
// left is no constant but a setting, solver::Settings::residual in FilmSolver.h.
struct NewtonLimits {
    int newtonSteps = 24;     // at most
    int stepsWithoutGain = 6; // given up after so many in which the forces left did not shrink by
    double gain = 0.8;        // this factor from the least yet
    int shortenings = 6;      // of one Newton step, by half each, at most
    double sufficientDecrease = 0.1; // of the forces left, times the share of the step taken
    // The residual of a Newton step's linear system: this share of the forces that may be left at
    // the end, or that share of those left now, whichever is larger.
    double linearShareOfAllowed = 0.5, linearShareOfLeft = 0.02;
    // On a point, over the film's shear stiffness times the farthest that a point has come from its
    // rest, or the film's longest edge, or 1 mm, whichever is most. Below it, on the average, the
    // film is at rest to the precision of its numbers.
    double flatForce = 1e-6;
};

// A stiffer film's: over the film's shear stiffness, and from try to try.
inline constexpr double leastStiffening = 0.5, mostStiffening = 8, stiffeningFactor = 4;

// Film that finds no equilibrium: the points with at least such a share of the largest force on any
// are held, and so many times over in one step.
inline constexpr double unbalancedShare = 0.1;
inline constexpr int mostHolds = 4;

// A point moves at most so far in one Newton step: in cells, by their longer edge.
inline constexpr double longestNewtonStep = 2;
inline constexpr double shortestNewtonStep = 1e-30; // mm: only keeps a division from zero

// The method of least residuals: vectors before it starts anew, and how often it does.
inline constexpr int mostBasisVectors = 12;
inline constexpr int mostRestarts = 4;

// When in a step a point meets the body (Adhesion.h): halvings of the step.
inline constexpr int contactTimeHalvings = 24;

// Where the contact line is (ContactPath.h).
inline constexpr int contactLineHalvings = 20; // of the way from a place in the body to one outside
inline constexpr int contactLineNewtonSteps = 12;  // in the water plane, at most
inline constexpr int acrossLineNewtonSteps = 6;    // along a line's normal, at most
inline constexpr int surfaceNewtonSteps = 3;       // along ∇φ to the surface, at most
inline constexpr double contactLineReached = 1e-4; // distance left, in cells
// The share of ∇φ in the water plane (|∇φ| is 1 nearly everywhere). On flatter places there is no
// contact line, and a search along a line's normal stops; the search in the plane for a line, which
// may start far from it, stops at a share whose square is the second number.
inline constexpr double leastSlope = 0.02, leastPlaneSlopeSquared = 0.0025;
inline constexpr double leastGradientSquared = 0.04; // |∇φ|²: less is a ridge

} // namespace dipwright::numerics

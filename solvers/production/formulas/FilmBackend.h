// Defines what a step of the production film requires of the device that computes it. The step
// (FilmStep.h) and the search for equilibrium (Equilibrium.h) are written once, on top of these
// functions.
//
// On a GPU, a team of threads runs the step of a film together. On the CPU, the team is one thread,
// which may use helper threads. The whole team calls each member, in the same order. Points are
// numbered row by row. Triangles are numbered cell by cell, two per cell.
#pragma once

#include "production/formulas/Adhesion.h"
#include "production/formulas/FilmModel.h"
#include "production/formulas/OrderlessSum.h"
#include "production/formulas/Tolerances.h"

#include <concepts>

namespace dipwright::numerics {

// Roots of sums of squares: of the remaining forces on free points, and of the elastic forces on
// the horizontal edges of moving triangles.
struct FilmForce {
    double left = 0, elastic = 0;
};

// The effect of the whole contact line on a step.
template <typename Real>
struct LineState {
    Real steepness{1};   // smallest steepness of the whole line, see ContactLine
    bool driven = false; // a triangle that can still move crosses the contact line
    Real upwards{-1};    // the largest CrossingTriangle::upwards, or -1
};

// The small least-squares problem of GMRES. It contains the Hessenberg matrix, which Givens
// rotations make upper triangular, the right side, whose last number is the residual, and the
// weights of the basis vectors.
struct GmresProblem {
    double matrix[mostBasisVectors][mostBasisVectors + 1] = {}; // column by column
    double cosine[mostBasisVectors] = {}, sine[mostBasisVectors] = {};
    double right[mostBasisVectors + 1] = {};
    double weights[mostBasisVectors] = {};
};

// Returns the factor that scales a basis vector of this length to length 1; 0 if it has no length.
DIPWRIGHT_HOST_DEVICE inline float inverseLength(double length) {
    return length > 0 ? float(1 / length) : 0.f;
}

namespace detail {

// The signatures of the functions that a step passes to the backend, for the concept below.
struct PointWork {
    void operator()(int point) const;
};
struct PointQuestion {
    bool operator()(int point) const;
};
template <typename Real>
struct PointFold {
    Real operator()(int point, Real value) const;
};
struct TriangleWork {
    void operator()(int triangle) const;
};
struct TriangleQuestion {
    bool operator()(const TriangleCorners& corners) const;
};
struct SmallWork {
    double operator()(GmresProblem& problem) const;
};
template <typename Real>
struct CrossingWork {
    void operator()(int triangle, const CrossingTriangle<Real>&, CrossingAnchor<Real>&) const;
};
template <typename Real>
struct Unfolding {
    UnfoldedTriangle<Real> operator()(int triangle, const TriangleCorners& corners) const;
};

} // namespace detail

// Stores the values of each film point and triangle, addressed by number. The device chooses the
// arrays.
template <typename Film, typename Real = typename Film::Real>
concept FilmStorage = requires(Film& film, const Film& seen, int i, Vector2<Real> way,
                               Vector3<Real> place, Real value, Matrix2<Real> shape) {
    { seen.model() } -> std::convertible_to<const FilmModel<Real>&>;
    { seen.body() } -> std::convertible_to<const ContactBody<Real>&>;
    { film.state() } -> std::same_as<StepState<Real>&>;

    // Displacement in the water plane, mm from rest: now, and at the end of the previous step.
    { seen.displacement(i) } -> std::same_as<Vector2<Real>>;
    { seen.before(i) } -> std::same_as<Vector2<Real>>;
    film.setDisplacement(i, way);
    film.setBefore(i, way);
    // Records why a point lies where it does. Several threads may mark the same point at once.
    film.mark(i, solver::PointMark::Torn);
    // The state of a point and its place on the body (body coordinates).
    { seen.pointState(i) } -> std::same_as<solver::PointState>;
    { seen.attached(i) } -> std::same_as<Vector3<Real>>;
    film.attach(i, place, solver::PointState{});
    // Whether the equilibrium may move the point. A call of hold() takes effect at the next
    // setFree().
    { seen.moves(i) } -> std::same_as<bool>;
    film.hold(i);
    // Lower bound of the distance to contact, mm.
    { seen.clearance(i) } -> std::same_as<Real>;
    film.setClearance(i, value);

    // A triangle's inverse rest shape, its current edges in the plane, whether a corner could move
    // at the last setFree(), and how it lies on the body.
    { seen.shape(i) } -> std::same_as<Matrix2<Real>>;
    film.setShape(i, shape);
    { seen.edges(i) } -> std::same_as<EdgePair<Real>>;
    { seen.triangleMoves(i) } -> std::same_as<bool>;
    { film.laid(i) } -> std::same_as<LaidCorners<Real>&>;
};

template <typename Film, typename Real = typename Film::Real>
concept FilmTeam = requires(Film& film, Real value, bool flag, detail::PointWork forPoint,
                            detail::PointQuestion askPoint, detail::PointFold<Real> fold,
                            detail::TriangleWork forTriangle, detail::TriangleQuestion crosses,
                            detail::CrossingWork<Real> forCrossing,
                            detail::Unfolding<Real> unfolding) {
    // A barrier: afterwards all threads see what any thread of the team wrote before.
    film.barrier();
    // least() returns the smallest value over all threads of the team, anyOf() whether any thread's
    // flag is set. Both act as barriers.
    { film.least(value) } -> std::same_as<Real>;
    { film.anyOf(flag) } -> std::same_as<bool>;

    // Calls work(point) for all points. Helper threads may call it.
    film.forPoints(forPoint);
    // Calls ask(point) for all points; helper threads may call it. Returns whether the answer was
    // true for any point of this thread.
    { film.anyPoint(askPoint) } -> std::same_as<bool>;
    // Each thread begins with `value` and replaces it by fold(point, value) for each of its points,
    // in ascending order. Returns the smallest value over all threads of the team, and acts as a
    // barrier. Helper threads may call `fold`.
    { film.leastOver(value, fold) } -> std::same_as<Real>;
    // Makes the triangles that satisfy crosses(corners) the crossing triangles; unfold(triangle,
    // corners) gives their values. If the set of triangles has not changed, they keep their
    // anchors. Helper threads may call both functions.
    { film.findCrossing(crosses, unfolding) } -> std::same_as<LineState<Real>>;
    // Calls work(triangle, crossing, anchor) for the crossing triangles. Each thread gets its
    // triangles in ascending order, so `work` may use variables of its own thread.
    film.forCrossing(forCrossing);
    // Calls onLine(triangle, crossing, anchor) for the crossing triangles and floating(triangle)
    // for all others. Helper threads may call both functions.
    film.forTriangles(forCrossing, forTriangle);
    // A device may also have relaxTriangles(onLine, keep): the same, where floating() gives a
    // triangle its relaxedInverseShape().
    // Does the same for all triangles that may be stretched to more than `value` times their length
    // or area, and possibly for other triangles. Each thread gets its triangles in ascending order,
    // as in forCrossing.
    film.forStretched(value, forCrossing, forTriangle);
};

// Computes the film's forces, including a water drag of `drag` on each point (WaterDrag.h).
template <typename Film, typename Real = typename Film::Real>
concept FilmEquilibrium = requires(Film& film, Real drag, Real length, double number) {
    { film.model() } -> std::convertible_to<const FilmModel<Real>&>;
    { Film::newtonLimits() } -> std::same_as<NewtonLimits>;
    // Tells the equilibrium which points can move. Does not include a barrier.
    film.setFree();
    // force() computes the forces at the current displacement. forceAlong() first sets the
    // displacement to that of the last startOfStep() plus `length` Newton steps.
    { film.force(drag) } -> std::same_as<FilmForce>;
    { film.forceAlong(length, drag) } -> std::same_as<FilmForce>;
    // Returns the remaining force on a point at the last force computation; zero for a held point.
    { film.forceOn(0) } -> std::same_as<Vector2<Real>>;
    // Prepares solveLinear() for the film's stiffness at the last force computation. solveLinear()
    // may be called at that displacement or near it. With another drag it takes more iterations.
    film.prepareLinear(drag);
    // Solves H · step = −(the last forces) for the Newton step; H is the derivative of the forces.
    // The first number is the residual of a zero step. The second is the residual at which the
    // search may stop.
    film.solveLinear(drag, Tangent::True, number, number);
    // Saves the displacement as the start of the Newton step. Returns the largest motion of a point
    // along X or Z in the whole step, mm.
    { film.startOfStep() } -> std::same_as<double>;
    // Saves the displacement as the best so far, and restores it.
    film.keepBest();
    film.takeBest();
};

template <typename Film>
concept FilmBackend = FilmStorage<Film> && FilmTeam<Film> && FilmEquilibrium<Film>;

// Defines what GMRES requires of a device: basis vectors and smoothed basis vectors. Smoothing
// means multiplication by M⁻¹, a multigrid cycle (GalerkinCycle.h).
template <typename Film, typename Real = typename Film::Real>
concept GmresBackend = requires(Film& film, Real value, int count) {
    // Lets one thread call work(problem) → double on the small problem, for all threads that share
    // it.
    { film.inSmallProblem(detail::SmallWork{}) } -> std::same_as<double>;
    // Makes the forces times `value` the first basis vector.
    film.startBasis(value);
    // Smooths basis vector `count` and makes the next basis vector: H times the smoothed vector,
    // made orthogonal to the earlier vectors and scaled to length 1. Column `count` of the small
    // problem's matrix receives the products with the earlier vectors, and the length before
    // scaling.
    film.extendBasis(count, value, Tangent::True);
    // Makes the step the negative sum of the first `count` smoothed vectors, times their weights in
    // the small problem; zero if `count` is 0.
    film.setStep(count);
};

} // namespace dipwright::numerics

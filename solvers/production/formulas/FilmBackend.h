// What a step of the production film's dip asks of the device that computes it. The step itself
// (FilmStep.h) and the search for equilibrium (Equilibrium.h) are written once, over this.
//
// On a GPU a film is in the hands of a team of threads, all of which run the step together; on the
// CPU the team is one thread, which may have others help it. Every member is called by the whole
// team, in the same order. Points and triangles go by their number: row after row, and two
// triangles a cell, cell after cell.
#pragma once

#include "production/formulas/Adhesion.h"
#include "production/formulas/FilmModel.h"
#include "production/formulas/Tolerances.h"

#include <concepts>

namespace dipwright::numerics {

// Roots of sums of squares: of the forces left on the free points, and of the elastic forces within
// the film, on the horizontal edges of triangles that move.
struct FilmForce {
    double left = 0, elastic = 0;
};

// What the whole contact line does to a step.
template <typename Real>
struct LineState {
    Real steepness{1};   // the least of all its places
    bool driven = false; // some triangle crosses it that still moves
};

// The small least-squares problem of GMRES: the Hessenberg matrix, turned upper triangular by
// Givens rotations as it grows; the right side, of which the last number taken is the residual; and
// the weights of the basis vectors.
struct LeastResiduals {
    double matrix[mostBasisVectors][mostBasisVectors + 1] = {}; // by columns
    double cosine[mostBasisVectors] = {}, sine[mostBasisVectors] = {};
    double right[mostBasisVectors + 1] = {};
    double weights[mostBasisVectors] = {};
};

namespace detail {

// Stand-ins for what a step has done for each point and triangle.
struct PointWork {
    void operator()(int point) const;
};
struct TriangleWork {
    void operator()(int triangle) const;
};
struct TriangleQuestion {
    bool operator()(const TriangleCorners& corners) const;
};
struct SmallWork {
    double operator()(LeastResiduals& problem) const;
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

// What is kept of each film point and triangle, read and written by their numbers. In what kind of
// array is the device's affair.
template <typename Film, typename Real = typename Film::Real>
concept FilmStorage = requires(Film& film, const Film& seen, int i, Vector2<Real> way,
                               Vector3<Real> place, Real value, Matrix2<Real> shape) {
    { seen.model() } -> std::convertible_to<const FilmModel<Real>&>;
    { seen.body() } -> std::convertible_to<const ContactBody<Real>&>;
    { film.state() } -> std::same_as<StepState<Real>&>;

    // mm from rest in the water plane: now, and at the end of the step before.
    { seen.displacement(i) } -> std::same_as<Vector2<Real>>;
    { seen.before(i) } -> std::same_as<Vector2<Real>>;
    film.setDisplacement(i, way);
    film.setBefore(i, way);
    // Why a point lies where it does. Threads of a team may mark the same point at once.
    film.mark(i, solver::PointMark::Torn);
    // What has become of a point, and where it sits on the body (body coordinates).
    { seen.pointState(i) } -> std::same_as<solver::PointState>;
    { seen.attached(i) } -> std::same_as<Vector3<Real>>;
    film.attach(i, place, solver::PointState{});
    // Whether the equilibrium may move the point; hold(): no more, from the next setFree() on.
    { seen.moves(i) } -> std::same_as<bool>;
    film.hold(i);
    // mm, at least so far from contact.
    { seen.clearance(i) } -> std::same_as<Real>;
    film.setClearance(i, value);

    // A triangle's inverse rest shape, its edges in the plane now, whether a corner of it moves as
    // of the last setFree(), and how it lies on the body.
    { seen.shape(i) } -> std::same_as<Matrix2<Real>>;
    film.setShape(i, shape);
    { seen.edges(i) } -> std::same_as<EdgePair<Real>>;
    { seen.triangleMoves(i) } -> std::same_as<bool>;
    { film.laid(i) } -> std::same_as<LaidCorners<Real>&>;
};

template <typename Film, typename Real = typename Film::Real>
concept FilmTeam = requires(Film& film, Real value, bool flag, detail::PointWork forPoint,
                            detail::TriangleWork forTriangle, detail::TriangleQuestion crosses,
                            detail::CrossingWork<Real> forCrossing,
                            detail::Unfolding<Real> unfolding) {
    // A barrier: what any thread of the team has written before, all see afterwards.
    film.barrier();
    // The least value, or whether any flag is set, of all threads of the team; a barrier as well.
    { film.least(value) } -> std::same_as<Real>;
    { film.anyOf(flag) } -> std::same_as<bool>;

    // work(point) for all points, each thread its share of them in ascending order: so work may
    // gather in variables of its own thread.
    film.forPoints(forPoint);
    // The triangles that cross the contact line become those of which crosses(corners) holds, each
    // as unfold(triangle, corners) has it; where they are the same as before they keep their
    // anchors. Both may be called by helping threads.
    { film.findCrossing(crosses, unfolding) } -> std::same_as<LineState<Real>>;
    // work(triangle, crossing, anchor) for these, as forPoints.
    film.forCrossing(forCrossing);
    // onLine(triangle, crossing, anchor) for these, and floating(triangle) for all others. May be
    // called by helping threads.
    film.forTriangles(forCrossing, forTriangle);
    // The same for all triangles that may be stretched to more than `value` times their length or
    // area, and perhaps for others; as forPoints.
    film.forStretched(value, forCrossing, forTriangle);
};

// The film's forces, with a drag of the water of so much on each point (WaterDrag.h).
template <typename Film, typename Real = typename Film::Real>
concept FilmEquilibrium = requires(Film& film, Real drag, Real length, double number) {
    { film.model() } -> std::convertible_to<const FilmModel<Real>&>;
    { Film::newtonLimits() } -> std::same_as<NewtonLimits>;
    // Tells the equilibrium which points move; a barrier.
    film.setFree();
    // At the displacement; then at that of the last startOfStep() plus `length` Newton steps, which
    // becomes the displacement.
    { film.force(drag) } -> std::same_as<FilmForce>;
    { film.forceAlong(length, drag) } -> std::same_as<FilmForce>;
    // What is left on a point of the forces last taken; nothing on one that is held.
    { film.forceOn(0) } -> std::same_as<Vector2<Real>>;
    // Readies solveLinear() for the stiffness that the film has where the forces were last taken:
    // which it is to solve for there or near by.
    film.prepareLinear(drag);
    // Solves H · step = −(the forces last taken) for the Newton step, H their derivative. The first
    // number is the residual of no step at all, the second the one at which the search may stop.
    film.solveLinear(drag, Tangent::True, number, number);
    // Remembers the displacement as where the step starts. Returns the farthest that the whole
    // step moves a point along X or Z, mm.
    { film.startOfStep() } -> std::same_as<double>;
    // Remembers the displacement as the best yet, and goes back to it.
    film.keepBest();
    film.takeBest();
};

template <typename Film>
concept FilmBackend = FilmStorage<Film> && FilmTeam<Film> && FilmEquilibrium<Film>;

// What the method of least residuals asks of such a device: vectors of a basis, and each of them
// smoothed, which is M⁻¹ times it, M⁻¹ a multigrid cycle (GalerkinCycle.h).
template <typename Film, typename Real = typename Film::Real>
concept LeastResidualBackend = requires(Film& film, Real value, int count, double* column) {
    // Has one thread do work(problem) → double on the small problem, for all that share it.
    { film.inSmallProblem(detail::SmallWork{}) } -> std::same_as<double>;
    // No step yet, the residual being the forces.
    film.startLinear();
    // The first basis vector is `value` times the residual.
    film.startBasis(value);
    // Smooths basis vector `count` and makes the next one: H times the smoothed one, orthogonal to
    // those before, of length one. Column `count` of the small problem's matrix becomes its
    // products with these and its length.
    film.extendBasis(count, value, Tangent::True);
    // step −= the first `count` smoothed vectors, each times its weight in the small problem.
    film.addToStep(count);
    // The residual becomes forces + H · step. Returns its root of the sum of squares.
    { film.linearResidual(value, Tangent::True) } -> std::same_as<double>;
};

} // namespace dipwright::numerics

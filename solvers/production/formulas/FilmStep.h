// Computes one step of the production film's dip (docs/film-model.md), in the same way on all
// devices.
//
// The film is a plane problem: each point has a place in the water plane. The equilibrium moves the
// free points, and adhered points are held. For triangles that cross the contact line, the body's
// surface, with its adhered points, is unfolded about this line (ContactPath.h).
//
// A step lowers the body until the contact line has travelled a fraction of a cell along the
// surface. Then the film finds its equilibrium. Each point that touched the surface during the step
// adheres where and when it touched. Where the body turns up, its grip fades, and the film follows
// only a share of the unfolding motion (LaidCorners). Where the body turns up too far, it releases
// the film. The edge of released film then stays at its place on the water. Torn film is also held
// at its place on the water, because it is soft and does not spring back.
#pragma once

#include "production/formulas/Equilibrium.h"
#include "production/formulas/FilmBackend.h"
#include "production/formulas/Growth.h"
#include "production/formulas/StepLength.h"
#include "production/formulas/TearLaw.h"
#include "production/formulas/WaterDrag.h"

#include <cmath>

namespace dipwright::numerics {

template <FilmStorage Film>
DIPWRIGHT_TEAM inline bool isFinished(Film& film) {
    return film.state().descent >= film.body().motion.travel;
}

namespace detail {

template <FilmStorage Film>
DIPWRIGHT_TEAM inline bool isFree(const Film& film, int point) {
    return film.pointState(point) == solver::PointState::Free;
}

// Returns the smallest distance between the body and any point that is not next to adhered film, or
// `most` if no point is nearer.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline double nearestClearance(Film& film, double most) {
    using Real = typename Film::Real;
    const FilmModel<Real>& model = film.model();
    const ContactBody<Real>& body = film.body();
    const BodyFrame<Real> frame = body.frameAt(film.state().descent);
    const auto free = [&](std::size_t point) { return isFree(film, int(point)); };
    return double(film.leastOver(Real(most), [&](int point, Real nearest) {
        if (film.clearance(point) < nearest &&
            !isNextToContact(model.columns, model.rows, point, free)) {
            const Vector3<Real> place =
                planePosition(model, std::uint32_t(point), film.displacement(point));
            const Real distance =
                sampleField(body.field, frame.toBody(place)).distance - body.contactDistance;
            nearest = distance < nearest ? distance : nearest;
        }
        return nearest;
    }));
}

// Returns the largest increment of the descent that keeps the limit on the contact line's travel.
// The increment also stops where another part of the body makes contact.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline double nextIncrement(Film& film) {
    const double cell = double(film.model().cell);
    const double travel = film.model().contactTravel * cell;
    const double increment =
        film.state().anyAdhered ? contactIncrement(travel, double(film.state().steepness)) : cell;
    return std::fmin(increment, approachIncrement(travel, nearestClearance(film, increment)));
}

DIPWRIGHT_TEAM inline void enter(const EquilibriumResult& found,
                                 solver::EquilibriumAccount& account) {
    if (!found.isReached) {
        ++account.stepsWithout;
        account.worstForceLeft = std::fmax(account.worstForceLeft, found.left);
    }
}

// Returns the smaller of `least` and the negative size of the larger component of `way`.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real lessOrFarther(Real least, const Vector2<Real>& way) {
    const Real x = -std::fabs(way.x), z = -std::fabs(way.z);
    const Real lower = x < z ? x : z;
    return lower < least ? lower : least;
}

// Returns the largest displacement of a point from rest along X or Z, mm. Acts as a barrier.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline double farthestFromRest(Film& film) {
    using Real = typename Film::Real;
    return -double(film.leastOver(Real(0), [&](int point, Real least) {
        return lessOrFarther(least, film.displacement(point));
    }));
}

// Moves free points as in the previous step, as a warm start for the equilibrium. Returns what
// farthestFromRest() would return then. Acts as a barrier.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline double predict(Film& film, double increment) {
    using Real = typename Film::Real;
    const Real cell = film.model().cell;
    const double last = film.state().increment;
    const Real factor = last > 0 && film.state().driven ? Real(increment / last) : Real(0);
    const auto limited = [cell](Real way) { return way < -cell ? -cell : way > cell ? cell : way; };
    return -double(film.leastOver(Real(0), [&](int point, Real least) {
        const Vector2<Real> now = film.displacement(point), before = film.before(point);
        Vector2<Real> next = now;
        if (film.moves(point)) {
            next = {now.x + limited(factor * (now.x - before.x)),
                    now.z + limited(factor * (now.z - before.z))};
            film.setDisplacement(point, next);
        }
        film.setBefore(point, now);
        return lessOrFarther(least, next);
    }));
}

template <FilmStorage Film>
DIPWRIGHT_TEAM inline void findCorners(const Film& film, const TriangleCorners& triangle,
                                       const BodyFrame<typename Film::Real>& frame,
                                       CrossingCorner<typename Film::Real> (&corners)[3]) {
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t point = triangle.points[k];
        corners[k] =
            crossingCorner(film.pointState(int(point)),
                           planePosition(film.model(), point, film.displacement(int(point))),
                           frame.toWorld(film.attached(int(point))));
    }
}

// Returns how far the body goes down or up at a triangle's held corners, per mm that it travels.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline double sinking(const CrossingCorner<Real> (&corners)[3],
                                            const BodyFrame<Real>& frame,
                                            const BodyFrame<Real>& ahead) {
    Real most(0);
    for (const CrossingCorner<Real>& corner : corners) {
        if (!corner.isFree) {
            const Real way = ahead.toWorld(frame.toBody(corner.held)).y - corner.held.y;
            most = std::fmax(most, std::fabs(way));
        }
    }
    return double(most) / sinkingTestedOver;
}

// Finds the triangles that cross the contact line with the body at `descent` and can still move,
// and unfolds the surface under them. If no contact line is near (a flat face, a submerged body),
// their corners do not move. `moved` is true if the body has moved, false if only the film has.
// Returns LineState::upwards.
template <FilmBackend Film>
DIPWRIGHT_TEAM DIPWRIGHT_CALLED typename Film::Real findContactLine(Film& film, double descent,
                                                                    bool moved) {
    using Real = typename Film::Real;
    const BodyFrame<Real> frame = film.body().frameAt(descent);
    const bool isOnPath = film.body().path.count > 0;
    const BodyFrame<Real> ahead =
        isOnPath ? film.body().frameAt(descent + sinkingTestedOver) : frame;
    const auto crosses = [&](const TriangleCorners& triangle) {
        bool anyHeld = false, moves = false;
        for (const std::uint32_t point : triangle.points) { // reads all corners at once
            anyHeld |= !isFree(film, int(point));
            moves |= film.moves(int(point));
        }
        return anyHeld && moves;
    };
    const auto unfold = [&](int triangle, const TriangleCorners& points) {
        CrossingCorner<Real> corners[3];
        findCorners(film, points, frame, corners);
        const TriangleSize<Real> size = triangleSize(film.model(), triangle);
        const Real cell = size.x < size.z ? size.x : size.z;
        LaidCorners<Real> laid = film.laid(triangle);
        UnfoldedTriangle<Real> unfolded =
            unfoldedTriangle(film.body(), frame, cell, points, corners, moved, laid);
        Lanes::wait(); // all lanes have read it; all write the same
        film.laid(triangle) = laid;
        unfolded.crossing.cell = std::uint32_t(triangle / 2);
        if (isOnPath) {
            unfolded.steepness =
                Real(steepnessOnPath(double(unfolded.steepness), sinking(corners, frame, ahead)));
        }
        return unfolded;
    };
    const LineState<Real> found = film.findCrossing(crosses, unfold);
    film.state().steepness = found.steepness;
    film.state().driven = found.driven;
    return found.upwards;
}

template <FilmBackend Film>
DIPWRIGHT_TEAM inline void moveAnchors(Film& film) {
    film.forCrossing(
        [](int, const auto& crossing, auto& anchor) { anchor = anchorOverStep(anchor, crossing); });
}

// Sets the anchors of the crossing triangles to the current gradients of their floating parts.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void setAnchors(Film& film) {
    film.forCrossing([&](int triangle, const auto& crossing, auto& anchor) {
        anchor = crossingAnchor(crossing, gradientOf(unfoldedEdges(film.edges(triangle), crossing),
                                                     film.shape(triangle)));
    });
}

// Holds the corners of film that is stretched too far. If the film did not converge
// (`didNotConverge`), also holds the corners of folded film. Returns whether this thread held any.
template <FilmBackend Film>
DIPWRIGHT_TEAM DIPWRIGHT_CALLED bool holdTornOrFolded(Film& film, bool didNotConverge) {
    using Real = typename Film::Real;
    const FilmModel<Real>& model = film.model();
    bool any = false;
    const auto hold = [&](int triangle, solver::PointMark why) {
        for (const std::uint32_t point :
             triangleCorners(model.columns, std::size_t(triangle)).points) {
            if (isFree(film, int(point))) {
                film.mark(int(point), why);
            }
            film.hold(int(point));
        }
        any = true;
    };
    // `isTurned`: whether the triangle's floating part is turned inside out.
    const auto holdIfLost = [&](int triangle, const EdgePair<Real>& edges, bool isTurned) {
        const TriangleSize<Real> size = triangleSize(model, triangle);
        const TriangleStretch<Real> stretch = triangleStretch(edges, size.x, size.z);
        if (isTorn(stretch, Real(model.tearStretch))) {
            hold(triangle, solver::PointMark::Torn);
        } else if (didNotConverge && (isTurned || isFolded(stretch))) {
            hold(triangle, solver::PointMark::Unbalanced);
        }
    };
    film.forStretched(
        Real(model.tearStretch),
        [&](int triangle, const auto& crossing, const auto& anchor) {
            if (film.triangleMoves(triangle)) {
                const EdgePair<Real> edges = unfoldedEdges(film.edges(triangle), crossing);
                const Matrix2<Real> floating =
                    floatingGradient(anchor, gradientOf(edges, film.shape(triangle)));
                holdIfLost(triangle, edges, determinant(floating) < Real(0));
            }
        },
        [&](int triangle) {
            if (film.triangleMoves(triangle)) {
                holdIfLost(triangle, film.edges(triangle), false);
            }
        });
    return any;
}

// Calls work(point) for the points with the largest remaining forces; these prevent convergence.
template <FilmBackend Film, typename Work>
DIPWRIGHT_TEAM inline void forUnbalanced(Film& film, const Work& work) {
    using Real = typename Film::Real;
    const auto squareAt = [&](int point) {
        const Vector2<Real> force = film.forceOn(point);
        return force.x * force.x + force.z * force.z;
    };
    const Real most = -film.leastOver(
        Real(0), [&](int point, Real least) { return std::fmin(least, -squareAt(point)); });
    film.forPoints([&](int point) {
        if (squareAt(point) >= Real(unbalancedShare * unbalancedShare) * most) {
            film.mark(point, solver::PointMark::Unbalanced);
            work(point);
        }
    });
}

// Finds the film's equilibrium at the end of a step. Holds points that prevent convergence, and
// continues the search. Film may have no equilibrium in the water plane if it is compressed at its
// own free edge or caught between two parts of the body. Real film leaves the plane there.
// `farthest` is farthestFromRest().
template <FilmBackend Film>
DIPWRIGHT_TEAM inline EquilibriumResult settle(Film& film, typename Film::Real drag,
                                               double farthest) {
    // The rounding error of a triangle's gradient grows with the triangle's edge. At first contact,
    // this error may be the only force. Without longestEdge as a lower bound, nearly all points
    // would then be held.
    farthest = std::fmax(farthest, film.model().longestEdge);
    EquilibriumResult found = findEquilibrium(film, drag, farthest);
    for (int holds = 0; holds < mostHolds && !found.isReached; ++holds) {
        film.force(drag);
        if (!film.anyOf(holdTornOrFolded(film, true))) {
            forUnbalanced(film, [&](int point) { film.hold(point); });
            film.barrier();
        }
        film.setFree();
        film.barrier();
        found = findEquilibrium(film, drag, farthest);
    }
    if (!found.isReached) {
        film.force(drag);
        forUnbalanced(film, [](int) {});
    }
    return found;
}

// Reduces the stretch to the share `keep`, because rest shapes creep towards the current shapes
// (PlaneStress.h). Also gives a whole crossing triangle the gradient of its floating part.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void relax(Film& film, typename Film::Real keep) {
    const auto& model = film.model();
    const auto onLine = [&](int triangle, const auto& crossing, const auto& anchor) {
        const auto shape = film.shape(triangle);
        const auto relaxed = relaxedCrossingShape(
            anchor, gradientOf(unfoldedEdges(film.edges(triangle), crossing), shape), shape, keep);
        const auto size = triangleSize(model, triangle);
        if (isShapeWithinLimits(relaxed, size.x, size.z)) {
            film.setShape(triangle, relaxed);
        }
    };
    if (keep == 1) {
        film.forCrossing(onLine);
        return;
    }
    if constexpr (requires { film.relaxTriangles(onLine, keep); }) {
        film.relaxTriangles(onLine, keep);
        return;
    }
    film.forTriangles(onLine, [&](int triangle) {
        const auto shape = film.shape(triangle);
        film.setShape(triangle,
                      relaxedInverseShape(shape, gradientOf(film.edges(triangle), shape), keep));
    });
}

// Returns the rest length of floating film in a step of `increment`, relative to its length at the
// start. While film is laid, returns the value at the middle of the step, the average time of
// laying. Before that, returns the value at the end of the step.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline double restLengthIn(Film& film, double increment) {
    const FilmModel<typename Film::Real>& model = film.model();
    const double share = film.state().anyAdhered ? 0.5 : 1;
    const double seconds = film.body().secondsAt(film.state().descent + share * increment);
    return grownLength(seconds, model.growthRate, model.growthLimit);
}

// Grows the rest shapes of floating film; film on the body does not grow. Does not include a
// barrier; the caller needs one.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void growTo(Film& film, double grown) {
    using Real = typename Film::Real;
    const Real shorter = Real(film.state().grown / grown);
    film.forTriangles(
        [&](int triangle, const auto&, auto& anchor) {
            film.setShape(triangle, scaled(film.shape(triangle), shorter));
            anchor.gradient = scaled(anchor.gradient, shorter);
        },
        [&](int triangle) { film.setShape(triangle, scaled(film.shape(triangle), shorter)); });
    film.state().grown = grown;
}

// Returns the displacement of a point that starts at the displacement `way` and grows freely by
// `share` of its rest position.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector2<Real> grownFreely(const FilmModel<Real>& model, int point,
                                                       const Vector2<Real>& way, Real share) {
    const Vector3<Real> rest = planePosition(model, std::uint32_t(point), Vector2<Real>{});
    const auto grown = [share](const GrowthOrigin& from, Real now, Real place) {
        return from.growsFreely ? now + share * (place - Real(from.place)) : now;
    };
    return {grown(model.alongXFrom, way.x, rest.x), grown(model.alongZFrom, way.z, rest.z)};
}

// Moves growing film that nothing touches to where free growth puts it, except near a held side.
// The water drag resists any other motion of the film.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void growFreely(Film& film, double share) {
    using Real = typename Film::Real;
    const bool isUntouched = !film.state().anyAdhered;
    film.forPoints([&](int point) {
        const auto grown = [&](const Vector2<Real>& way) {
            return grownFreely(film.model(), point, way, Real(share));
        };
        film.setBefore(point, grown(film.before(point)));
        if (isUntouched && film.moves(point)) {
            film.setDisplacement(point, grown(film.displacement(point)));
        }
    });
}

// Takes free growth (growFreely()) out of the film's position at the start of the step again, after
// the equilibrium.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void restoreBefore(Film& film, double share) {
    using Real = typename Film::Real;
    film.forPoints([&](int point) {
        film.setBefore(point, grownFreely(film.model(), point, film.before(point), Real(-share)));
    });
}

// Handles a point within the contact distance. Returns whether it stays on the body.
template <FilmStorage Film>
DIPWRIGHT_TEAM inline bool stick(Film& film, int point, double increment,
                                 const Vector3<typename Film::Real>& start,
                                 const Vector3<typename Film::Real>& end) {
    const auto met = attachment(film.body(), film.state().descent, increment, start, end - start);
    film.attach(point, met.place, met.state);
    const bool sticks = met.state != solver::PointState::Free;
    if (sticks) {
        film.hold(point);
    }
    return sticks;
}

// Makes free points adhere that are within the contact distance at the end of the step. A point far
// from the body is tested again only when the point or the body may have come near enough. Returns
// whether this thread found a contact.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline bool touch(Film& film, double increment) {
    using Real = typename Film::Real;
    const ContactBody<Real>& body = film.body();
    const BodyFrame<Real> frame = body.frameAt(film.state().descent + increment);
    return film.anyPoint([&](int point) {
        if (!isFree(film, point)) {
            return false;
        }
        bool hasTouched = false;
        const Vector2<Real> now = film.displacement(point), before = film.before(point);
        const Vector2<Real> way{now.x - before.x, now.z - before.z};
        Real clearance =
            film.clearance(point) - (Real(increment) + std::sqrt(way.x * way.x + way.z * way.z));
        if (!(clearance > Real(0))) {
            const Vector3<Real> end = planePosition(film.model(), std::uint32_t(point), now);
            const Real distance =
                sampleField(body.field, frame.toBody(end)).distance - body.contactDistance;
            if (distance <= Real(0)) {
                const Vector3<Real> start =
                    planePosition(film.model(), std::uint32_t(point), before);
                hasTouched = stick(film, point, increment, start, end);
            } else {
                // A third of the distance, so that this is safe outside the field's grid too.
                clearance = distance / Real(3);
            }
        }
        film.setClearance(point, clearance);
        return hasTouched;
    });
}

// Releases film where the body at `descent` turns up too far to hold it. Acts as a barrier.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void releaseOverhang(Film& film, double descent) {
    using Real = typename Film::Real;
    film.forCrossing([&](int triangle, const auto& crossing, const auto&) {
        if (crossing.upwards > film.body().steepestHeld) {
            const TriangleCorners points =
                triangleCorners(film.model().columns, std::size_t(triangle));
            CrossingCorner<Real> corners[3];
            findCorners(film, points, film.body().frameAt(descent), corners);
            const Matrix2<Real> change =
                releaseTriangle(film.body(), points, crossing, corners, film.laid(triangle));
            film.setShape(triangle, change * film.shape(triangle));
            for (const std::uint32_t point : points.points) {
                if (isFree(film, int(point))) {
                    film.mark(int(point), solver::PointMark::LetGo);
                }
            }
        }
    });
    film.barrier();
}

} // namespace detail

// Computes one step of a film that is not finished.
template <FilmBackend Film>
DIPWRIGHT_TEAM inline void step(Film& film) {
    using Real = typename Film::Real;
    StepState<Real>& dip = film.state();
    const FilmModel<Real>& model = film.model();
    const solver::BodyMotion& motion = film.body().motion;
    const double increment = std::fmin(detail::nextIncrement(film), motion.travel - dip.descent);
    const double end = dip.descent + increment;
    double farthest = detail::predict(film, increment);
    const double grown = detail::restLengthIn(film, increment);
    const double drift = grown - dip.grown;
    if (grown > dip.grown) {
        detail::growTo(film, grown);
    }
    if (drift > 0) {
        detail::growFreely(film, drift);
        farthest = detail::farthestFromRest(film);
    }
    bool hasLost = false;
    if (dip.anyAdhered || dip.grown != 1) {
        detail::findContactLine(film, end, true);
        detail::moveAnchors(film);
        film.barrier();
        const Real drag = Real(pointDrag(model.spacingX, model.spacingZ, increment));
        detail::enter(detail::settle(film, drag, farthest), dip.equilibrium);
        hasLost = detail::holdTornOrFolded(film, false);
        film.barrier(); // the corners' states were read; touch() changes them
        detail::relax(film, Real(keptStress(film.body().secondsOf(dip.descent, increment),
                                            model.relaxationTime)));
    }
    if (drift > 0) {
        detail::restoreBefore(film, drift);
    }
    // 2: film adhered; 1: film was lost
    const int own = detail::touch(film, increment) ? 2 : hasLost ? 1 : 0;
    const Real happened = -film.least(Real(-own));
    dip.anyAdhered = happened > 1 || dip.anyAdhered;
    if (dip.anyAdhered) {
        if (detail::findContactLine(film, end, false) > film.body().steepestHeld) {
            detail::releaseOverhang(film, end);
            detail::findContactLine(film, end, false);
        }
        detail::setAnchors(film);
    }
    if (happened > 0) {
        film.setFree();
    }
    dip.descent = end;
    dip.increment = increment;
    ++dip.steps;
}

} // namespace dipwright::numerics

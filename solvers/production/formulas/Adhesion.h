// Computes where film points adhere to the body, and where the corners of triangles lie after the
// body's surface is unfolded. This is the part of a step that works point by point and triangle by
// triangle (docs/film-model.md, "Contact in time" and "At the contact line").
#pragma once

#include "common/BodyPath.h"
#include "common/RootBetween.h"
#include "production/formulas/ContactPath.h"
#include "production/formulas/CrossingTriangle.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>

namespace dipwright::numerics {

// The body during contact with the film.
template <typename Real>
struct ContactBody {
    FieldGrid<Real> field;
    solver::BodyMotion motion;
    PathView path; // owned by the film
    Real contactDistance{};
    // Two values of the y component of the unit normal. Up to `firmlyHeld`, the body holds film
    // fully; past `steepestHeld`, not at all.
    Real firmlyHeld{}, steepestHeld{};

    // Returns the body's frame after it has descended, or has travelled along its path, by
    // `travelled` mm.
    DIPWRIGHT_HOST_DEVICE BodyFrame<Real> frameAt(double travelled) const {
        return path.count == 0 ? bodyFrame<Real>(motion, travelled)
                               : frameOnPath<Real>(path, travelled);
    }
    // Returns the time since the dip began, s.
    DIPWRIGHT_HOST_DEVICE double secondsAt(double travelled) const {
        return path.count == 0 ? travelled / motion.speed : secondsOnPath(path, travelled);
    }
    // Returns how long a step from `travelled` takes, s.
    DIPWRIGHT_HOST_DEVICE double secondsOf(double travelled, double increment) const {
        return path.count == 0 ? increment / motion.speed
                               : secondsAt(travelled + increment) - secondsAt(travelled);
    }
};

// Returns the body of a dip; it refers to the poses of the setup's path. The unfolding moves film
// along with the body's surface. The grip g is the share of this motion that the film follows; it
// slips by the rest. Let u be the y component of the body's normal at the contact line. When the
// line advances by 1 along the surface, it recedes by u on the water. Then the length g − (1 − g) u
// of film is laid; without slip, it is 1. No film may be laid past the overhang, so this length
// must be zero there. g falls linearly with u from `firmlyHeld`. So the length is zero at the
// overhang if g is zero at `steepestHeld` as computed below.
template <typename Real>
ContactBody<Real> contactBody(const solver::DipSetup& setup) {
    const double last = std::sin(setup.settings.overhang);
    const double firmly = std::sin(setup.settings.overhang - setup.settings.gripFade);
    return {fieldGrid<Real>(setup.field),
            setup.motion,
            pathView(setup.path),
            Real(setup.settings.contactDistance),
            Real(firmly),
            Real(last + std::max(last, 0.0) * (last - firmly))};
}

// A film point that has touched the body in a step. A face that turns up too far does not hold the
// point. The point then stays free at first, because film that is released in the same step may
// pull it back. If the point is still there one step later, it becomes trapped.
template <typename Real>
struct Attachment {
    Vector3<Real> place; // body coordinates
    solver::PointState state{};
};

// Handles a point that moved from `start` by `way` while the body descended from `descent` by
// `increment`, and that ended within the contact distance. Returns the place of the contact and its
// time within the step.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Attachment<Real> attachment(const ContactBody<Real>& body,
                                                         double descent, double increment,
                                                         Vector3<Real> start, Vector3<Real> way) {
    const auto placeAt = [&](Real share) {
        return body.frameAt(descent + increment * double(share)).toBody(start + way * share);
    };
    const auto clearanceAt = [&](Real share) {
        return sampleField(body.field, placeAt(share)).distance - body.contactDistance;
    };
    const Real first = clearanceAt(Real(0)), last = clearanceAt(Real(1));
    const bool wasIn = !(first > Real(0));
    const Real time = wasIn            ? Real(0)
                      : last > Real(0) ? Real(1) // by rounding
                                       : rootBetween(clearanceAt, first, last);
    const Vector3<Real> place = placeAt(time);
    const Vector3<Real> gradient = body.frameAt(descent + increment * double(time))
                                       .directionToWorld(smoothGradient(body.field, place));
    if (!(gradient.y > body.steepestHeld * length(gradient))) {
        return {place, solver::PointState::Adhered};
    }
    return {place, wasIn ? solver::PointState::Trapped : solver::PointState::Free};
}

// A corner of a triangle that crosses the contact line.
template <typename Real>
struct CrossingCorner {
    bool isFree{};
    // Place in the water plane.
    Vector3<Real> plane;
    // If the corner is held: its place on the body, in the world.
    Vector3<Real> held;
    // The corner is on a face that turns up too far. The triangle then ignores its place on the
    // body.
    bool isTrapped{};
};

// How film lies at the held corners of a triangle; kept from step to step. All values are 0 before
// the triangle crosses the contact line. Places are in the water plane, relative to the corner's
// place there.
//
// The body's grip fades where its surface turns up. There the film takes part in only a share of
// the unfolding motion, and slips.
template <typename Real>
struct LaidCorners {
    Real unfoldedX[3] = {}, unfoldedZ[3] = {};
    Real slipX[3] = {}, slipZ[3] = {}; // vector from the unfolded place to the real place
    Real upwards[3] = {};              // see ContactLine::upwards
    bool isHeld[3] = {};
    bool isReleased[3] = {}; // the corner is no longer held and stays in its place
    Real lost = 0;           // share of the triangle's weight that was cut off at the release
};

// Returns the corner of a triangle. `held` is the corner's place in the world; it may have any
// value for a free point.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline CrossingCorner<Real>
crossingCorner(solver::PointState state, const Vector3<Real>& plane, const Vector3<Real>& held) {
    CrossingCorner<Real> corner;
    corner.isFree = state == solver::PointState::Free;
    corner.plane = plane;
    corner.held = corner.isFree ? Vector3<Real>{} : held;
    corner.isTrapped = state == solver::PointState::Trapped;
    return corner;
}

template <typename Real>
struct UnfoldedTriangle {
    CrossingTriangle<Real> crossing; // complete except for its cell
    Real steepness = 1;              // the smallest steepness of its contact lines, see ContactLine
    Vector3<Real> offset[3];         // per corner: vector from `plane` to the film
    Real upwards[3] = {-1, -1, -1};  // per held corner: ContactLine::upwards
};

namespace detail {

// Returns the grip where the body's surface turns up by `upwards`: 1 up to `firmlyHeld`, falling to
// 0 at `steepestHeld`.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real grip(const ContactBody<Real>& body, Real upwards) {
    const Real share = (body.steepestHeld - upwards) / (body.steepestHeld - body.firmlyHeld);
    return std::fmin(std::fmax(share, Real(0)), Real(1));
}

// Returns the place of the film, relative to the corner's place in the plane.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real> offset(const LaidCorners<Real>& film, int k) {
    return {film.unfoldedX[k] + film.slipX[k], Real(0), film.unfoldedZ[k] + film.slipZ[k]};
}

// Moves corner `k` to its new unfolded `position`. `upwards` is ContactLine::upwards. `moved`:
// whether the body has moved. If the corner became held in this step, it starts vertically above
// its place on the body, because it was on the contact line during the step.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline void
slide(const ContactBody<Real>& body, const CrossingCorner<Real>& corner, int k,
      const Vector3<Real>& position, Real upwards, bool moved, LaidCorners<Real>& film) {
    const Real x = position.x - corner.plane.x, z = position.z - corner.plane.z;
    if (!film.isHeld[k]) {
        film.isHeld[k] = moved = true;
        film.unfoldedX[k] = corner.held.x - corner.plane.x;
        film.unfoldedZ[k] = corner.held.z - corner.plane.z;
        film.slipX[k] = film.slipZ[k] = Real(0);
        film.upwards[k] = upwards;
    }
    if (moved) {
        const Real loose = Real(1) - grip(body, (film.upwards[k] + upwards) / Real(2));
        film.slipX[k] -= loose * (x - film.unfoldedX[k]);
        film.slipZ[k] -= loose * (z - film.unfoldedZ[k]);
    }
    film.unfoldedX[k] = x;
    film.unfoldedZ[k] = z;
    film.upwards[k] = upwards;
}

// Returns the floating fraction of the side between two corners, at least `leastFloatingFraction`.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real floatingShare(bool isFree, Real distance, bool otherIsFree,
                                                Real otherDistance, Real cell) {
    if (isFree == otherIsFree) {
        return isFree ? Real(1) : Real(0);
    }
    const Real all = distance + otherDistance;
    return all > Real(1e-6) * cell
               ? std::fmax((isFree ? distance : otherDistance) / all, Real(leastFloatingFraction))
               : Real(1);
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline int freeCount(const CrossingCorner<Real> (&corners)[3]) {
    return corners[0].isFree + corners[1].isFree + corners[2].isFree;
}

// Returns the mean place of the free corners.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real> middleOfFree(const CrossingCorner<Real> (&corners)[3]) {
    Vector3<Real> sum;
    for (const CrossingCorner<Real>& corner : corners) {
        sum = corner.isFree ? sum + corner.plane : sum;
    }
    return sum * (Real(1) / Real(freeCount(corners)));
}

// Returns the mean place of the held corners on the body.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real> middleOfHeld(const CrossingCorner<Real> (&corners)[3]) {
    Vector3<Real> sum;
    for (const CrossingCorner<Real>& corner : corners) {
        sum = corner.isFree ? sum : sum + corner.held;
    }
    return sum * (Real(1) / Real(3 - freeCount(corners)));
}

// Sets values[k] to work(k) for the chosen corners, at most two of them. On a GPU, each of two
// sides of the triangle's lanes computes one of them.
template <typename Value, typename Work>
DIPWRIGHT_HOST_DEVICE inline void forCorners(const bool (&chosen)[3], Value (&values)[3],
                                             const Work& work) {
    if constexpr (Lanes::sides == 1) {
        for (int k = 0; k < 3; ++k) {
            if (chosen[k]) {
                values[k] = work(k);
            }
        }
    } else if (chosen[0] || chosen[1] || chosen[2]) {
        const int first = chosen[0] ? 0 : chosen[1] ? 1 : 2;
        const int last = chosen[2] ? 2 : chosen[1] ? 1 : 0;
        const Value own = work(Lanes::side() == 0 ? first : last);
        for (int k = 0; k < 3; ++k) {
            if (chosen[k]) {
                values[k] = Lanes::fromSide(own, k == first ? 0 : 1);
            }
        }
    }
}

// Returns whether two corners lie on two parts of the body that face each other across water.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool spansGap(const ContactBody<Real>& body,
                                           const BodyFrame<Real>& frame, Real cell,
                                           const CrossingCorner<Real> (&corners)[3]) {
    if (freeCount(corners) != 1) {
        return false;
    }
    const Vector3<Real> middle = middleOfHeld(corners);
    if (!(sampleWorld(body.field, frame, {middle.x, Real(0), middle.z}).distance >
          body.contactDistance)) {
        return false;
    }
    const bool held[3] = {!corners[0].isFree, !corners[1].isFree, !corners[2].isFree};
    ContactLine<Real> lines[3];
    forCorners(held, lines, [&](int k) {
        return contactLine(body.field, frame, body.contactDistance, cell, corners[k].held,
                           middleOfFree(corners));
    });
    const ContactLine<Real>&first = lines[held[0] ? 0 : 1], &second = lines[held[2] ? 2 : 1];
    return first.found && second.found && dot(first.outwards, second.outwards) < Real(0);
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline void setEdges(const TriangleCorners& triangle,
                                           const CrossingCorner<Real> (&corners)[3],
                                           UnfoldedTriangle<Real>& result) {
    const Vector3<Real>(&offset)[3] = result.offset;
    const int shared = triangle.shared();
    const Vector3<Real> horizontal = offset[1] - offset[0];
    const Vector3<Real> vertical =
        triangle.thirdAbove ? offset[2] - offset[shared] : offset[shared] - offset[2];
    CrossingTriangle<Real>& crossing = result.crossing;
    crossing.second = !triangle.thirdAbove;
    crossing.thirdOnRight = triangle.thirdOnRight;
    crossing.hx = horizontal.x;
    crossing.hz = horizontal.z;
    crossing.vx = vertical.x;
    crossing.vz = vertical.z;
    crossing.sharedFree = corners[shared].isFree;
    crossing.horizontalFree = corners[1 - shared].isFree;
    crossing.verticalFree = corners[2].isFree;
    crossing.upwards =
        std::fmax(result.upwards[0], std::fmax(result.upwards[1], result.upwards[2]));
}

// A held corner's own contact line, and where the corner lies after unfolding about it.
template <typename Real>
struct UnfoldedCorner {
    ContactLine<Real> line;
    Unfolded<Real> place; // only if the line was found
};

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedCorner<Real>
unfoldedCorner(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
               const Vector3<Real>& held, const Vector3<Real>& middleOfFree) {
    UnfoldedCorner<Real> corner;
    corner.line = contactLine(body.field, frame, body.contactDistance, cell, held, middleOfFree);
    if (corner.line.found) {
        corner.place = unfolded(body.field, frame, body.contactDistance, cell, corner.line, held);
    }
    return corner;
}

// Unfolds each held corner separately. Needed if more than one contact line holds the film, or if a
// part of the film has been released.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedTriangle<Real>
unfoldedApart(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
              const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3], bool moved,
              LaidCorners<Real>& film) {
    bool isSearched[3];
    for (int k = 0; k < 3; ++k) {
        isSearched[k] = !corners[k].isFree && !corners[k].isTrapped && !film.isReleased[k];
    }
    UnfoldedCorner<Real> found[3];
    forCorners(isSearched, found, [&](int k) {
        return unfoldedCorner(body, frame, cell, corners[k].held, middleOfFree(corners));
    });
    UnfoldedTriangle<Real> result;
    for (int k = 0; k < 3; ++k) {
        const ContactLine<Real>& line = found[k].line;
        if (corners[k].isFree || corners[k].isTrapped || (isSearched[k] && !line.found)) {
            continue;
        }
        if (isSearched[k]) {
            slide(body, corners[k], k, found[k].place.position, line.upwards, moved, film);
            result.upwards[k] = line.upwards;
            result.steepness = std::fmin(result.steepness, line.steepness);
        }
        result.offset[k] = offset(film, k);
    }
    setEdges(triangle, corners, result);
    CrossingTriangle<Real>& crossing = result.crossing;
    crossing.horizontalShare = crossing.verticalShare = crossing.diagonalShare =
        Real(1) - film.lost;
    return result;
}

// Unfolds all corners about the same contact line.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedTriangle<Real>
unfoldedTogether(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
                 const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3],
                 bool moved, LaidCorners<Real>& film) {
    UnfoldedTriangle<Real> result;
    const ContactLine<Real> line = contactLine(body.field, frame, body.contactDistance, cell,
                                               middleOfHeld(corners), middleOfFree(corners));
    const Real perFree = Real(1) / Real(freeCount(corners));
    const Real perHeld = Real(1) / Real(3 - freeCount(corners));
    Real distance[3] = {}; // distance to the contact line, along the surface or across the water
    Real floating(0), laid(0);
    Unfolded<Real> places[3];
    if (line.found) {
        const bool held[3] = {!corners[0].isFree, !corners[1].isFree, !corners[2].isFree};
        forCorners(held, places, [&](int k) {
            return unfolded(body.field, frame, body.contactDistance, cell, line, corners[k].held);
        });
    }
    for (int k = 0; k < 3 && line.found; ++k) {
        const CrossingCorner<Real>& corner = corners[k];
        if (corner.isFree) {
            distance[k] = std::fmax(dot(corner.plane - line.place, line.outwards), Real(0));
            floating += distance[k] * perFree;
        } else {
            const Unfolded<Real>& place = places[k];
            slide(body, corner, k, place.position, line.upwards, moved, film);
            result.offset[k] = offset(film, k);
            result.upwards[k] = line.upwards;
            distance[k] = place.path;
            laid += distance[k] * perHeld;
        }
    }
    setEdges(triangle, corners, result);
    result.steepness = line.steepness;
    const int shared = triangle.shared(), end = 1 - shared;
    const auto share = [&](int k, int l) {
        return floatingShare(corners[k].isFree, distance[k], corners[l].isFree, distance[l], cell);
    };
    CrossingTriangle<Real>& crossing = result.crossing;
    crossing.horizontalShare = share(shared, end);
    crossing.verticalShare = share(shared, 2);
    crossing.diagonalShare = share(end, 2);
    crossing.normalX = line.outwards.x;
    crossing.normalZ = line.outwards.z;
    crossing.floating =
        floating + laid > Real(1e-6) * cell ? floating / (floating + laid) : Real(1);
    return result;
}

} // namespace detail

// Unfolds the surface under a triangle with one or two held corners, and moves the film with it. If
// no contact line is near (a flat face, a submerged body), the corners do not move. `moved` is true
// if the body has moved, false if only the film has.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_CALLED UnfoldedTriangle<Real>
unfoldedTriangle(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
                 const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3],
                 bool moved, LaidCorners<Real>& film) {
    bool isApart = false;
    for (int k = 0; k < 3; ++k) {
        isApart = isApart || corners[k].isTrapped || film.isReleased[k];
    }
    return isApart || detail::spansGap(body, frame, cell, corners)
               ? detail::unfoldedApart(body, frame, cell, triangle, corners, moved, film)
               : detail::unfoldedTogether(body, frame, cell, triangle, corners, moved, film);
}

namespace detail {

// Cuts the laid part off a triangle whose corners on the body have all just been released. Moves
// these corners towards the free corners, as far as the contact line. The edge of the floating film
// is then there. Returns the factor for the triangle's inverse rest shape that keeps its stretch
// unchanged.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real>
cutAtLine(const TriangleCorners& triangle, const CrossingTriangle<Real>& crossing,
          const CrossingCorner<Real> (&corners)[3], LaidCorners<Real>& film) {
    const int shared = triangle.shared();
    const auto share = [&](int k, int l) {
        return k != 2 && l != 2             ? crossing.horizontalShare
               : k == shared || l == shared ? crossing.verticalShare
                                            : crossing.diagonalShare;
    };
    const Real perFree = Real(1) / Real(freeCount(corners));
    const Vector3<Real> free = middleOfFree(corners);
    Vector3<Real> before[3], after[3];
    Real weight(1);
    for (int k = 0; k < 3; ++k) {
        before[k] = after[k] = corners[k].plane;
        if (!corners[k].isFree) {
            Real floating(0);
            for (int l = 0; l < 3; ++l) {
                floating += corners[l].isFree ? perFree * share(k, l) : Real(0);
            }
            before[k] = corners[k].plane + offset(film, k);
            after[k] = free + (before[k] - free) * floating;
            weight *= floating;
        }
    }
    const auto edges = [&](const Vector3<Real>(&p)[3]) {
        const Vector3<Real> h = p[1] - p[0];
        const Vector3<Real> v = triangle.thirdAbove ? p[2] - p[shared] : p[shared] - p[2];
        return Matrix2<Real>{h.x, v.x, h.z, v.z};
    };
    const Matrix2<Real> whole = edges(before), cut = edges(after);
    if (!(std::fabs(cut.a * cut.d - cut.b * cut.c) > Real(0))) {
        return {Real(1), Real(0), Real(0), Real(1)};
    }
    for (int k = 0; k < 3; ++k) {
        film.slipX[k] += after[k].x - before[k].x;
        film.slipZ[k] += after[k].z - before[k].z;
    }
    film.lost = Real(1) - weight;
    return inverse(cut) * whole;
}

} // namespace detail

// Releases the corners of a triangle where the body turns up too far to hold film (`upwards` is
// past `steepestHeld`). Returns the factor for the triangle's inverse rest shape.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Matrix2<Real>
releaseTriangle(const ContactBody<Real>& body, const TriangleCorners& triangle,
                const CrossingTriangle<Real>& crossing, const CrossingCorner<Real> (&corners)[3],
                LaidCorners<Real>& film) {
    // Does not cut if the corners have different contact lines, or if some corners were released
    // earlier.
    bool isWhole = crossing.normalX != Real(0) || crossing.normalZ != Real(0);
    for (int k = 0; k < 3; ++k) {
        if (!corners[k].isFree && !film.isReleased[k]) {
            film.isReleased[k] = film.isHeld[k] && film.upwards[k] > body.steepestHeld;
            isWhole = isWhole && film.isReleased[k];
        }
    }
    return isWhole ? detail::cutAtLine(triangle, crossing, corners, film)
                   : Matrix2<Real>{Real(1), Real(0), Real(0), Real(1)};
}

} // namespace dipwright::numerics

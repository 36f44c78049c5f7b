// Where film points stick to the body, and what the triangles see of those that have: the part of a
// dip's step that is done point by point and triangle by triangle (film-physics §2.3, §2.4).
#pragma once

#include "pbd/ContactPath.h"
#include "pbd/CrossingTriangle.h"

namespace dipwright::pbd {

// The body as a film point meets it.
template <typename Real>
struct ContactBody {
    FieldGrid<Real> field;
    solver::BodyMotion motion;
    Real contactDistance{};
    Real steepestHeld{}; // sine of the overhang: film holds where the unit normal's y is at most so
};

// A film point that has met the body in a step. A face that turns up too far does not hold it. It
// stays free at first: film that is let go of in the same step draws it back. What is there still a
// step later is trapped.
template <typename Real>
struct Attachment {
    Vector3<Real> place; // body coordinates
    solver::PointState state{};
};

// The point that went from `start` by `way` while the body came down from `descent` by `increment`,
// to within the contact distance: at the moment in the step, and at the place, at which it met it.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Attachment<Real> attachment(const ContactBody<Real>& body,
                                                         double descent, double increment,
                                                         Vector3<Real> start, Vector3<Real> way) {
    Real early(0), late(1);
    const auto placeAt = [&](Real share) {
        return bodyFrame<Real>(body.motion, descent + increment * double(share))
            .toBody(start + way * share);
    };
    for (int iteration = 0; iteration < 24; ++iteration) {
        const Real middle = (early + late) / Real(2);
        const Real distance = sampleField(body.field, placeAt(middle)).distance;
        (distance > body.contactDistance ? early : late) = middle;
    }
    const Vector3<Real> place = placeAt(late);
    const Vector3<Real> gradient =
        bodyFrame<Real>(body.motion, 0).directionToWorld(smoothGradient(body.field, place));
    if (!(gradient.y > body.steepestHeld * length(gradient))) {
        return {place, solver::PointState::Adhered};
    }
    const bool wasIn = !(sampleField(body.field, placeAt(Real(0))).distance > body.contactDistance);
    return {place, wasIn ? solver::PointState::Trapped : solver::PointState::Free};
}

// A corner of a triangle that crosses the contact line.
template <typename Real>
struct CrossingCorner {
    bool isFree{};
    Vector3<Real> plane;  // in the water plane
    Vector3<Real> held;   // held: in the world, on the body
    bool isReleased{};    // held, but film has let go of the body there
    Vector3<Real> offset; // released: from `plane` to where it lies for good
};

// The corners of a triangle at which the body has turned up past what film holds on. There film has
// let go of it, and the water keeps it where it lay, unfolded, at that moment.
template <typename Real>
struct ReleasedCorners {
    Real x[3] = {}, z[3] = {}; // from the corner's place in the plane
    bool isReleased[3] = {};
};

// Corner `k` of a triangle; `held`: in the world, of a free point anything.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline CrossingCorner<Real>
crossingCorner(solver::PointState state, const Vector3<Real>& plane, const Vector3<Real>& held,
               const ReleasedCorners<Real>& released, int k) {
    CrossingCorner<Real> corner;
    corner.isFree = state == solver::PointState::Free;
    corner.plane = plane;
    corner.held = corner.isFree ? Vector3<Real>{} : held;
    // What was caught by a face that turns up too far has never been held on to.
    corner.isReleased = state == solver::PointState::Trapped || released.isReleased[k];
    if (released.isReleased[k]) {
        corner.offset = {released.x[k], Real(0), released.z[k]};
    }
    return corner;
}

template <typename Real>
struct UnfoldedTriangle {
    CrossingTriangle<Real> crossing; // but for its cell
    Real steepness = 1;              // least of the contact line, see ContactLine
    Vector3<Real> offset[3];         // of the corners, from `plane` to where they are unfolded
    Real upwards[3] = {-1, -1, -1};  // of the contact line of each corner that film holds on to
};

namespace detail {

// The floating fraction of the side between two corners, as far as it is told apart.
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

// Of the free corners.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real> middleOfFree(const CrossingCorner<Real> (&corners)[3]) {
    Vector3<Real> sum;
    for (const CrossingCorner<Real>& corner : corners) {
        sum = corner.isFree ? sum + corner.plane : sum;
    }
    return sum * (Real(1) / Real(freeCount(corners)));
}

// Of the held corners, on the body.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real> middleOfHeld(const CrossingCorner<Real> (&corners)[3]) {
    Vector3<Real> sum;
    for (const CrossingCorner<Real>& corner : corners) {
        sum = corner.isFree ? sum : sum + corner.held;
    }
    return sum * (Real(1) / Real(3 - freeCount(corners)));
}

// Whether two corners hold on to two places of the body that face each other across the water.
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
    Vector3<Real> outwards[2];
    int found = 0;
    for (const CrossingCorner<Real>& corner : corners) {
        if (!corner.isFree) {
            const ContactLine<Real> line = contactLine(body.field, frame, body.contactDistance,
                                                       cell, corner.held, middleOfFree(corners));
            if (!line.found) {
                return false;
            }
            outwards[found++] = line.outwards;
        }
    }
    return dot(outwards[0], outwards[1]) < Real(0);
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

// Every held corner unfolded by itself: of film that more than one contact line holds, or that has
// let go in part. Taken as floating all of it.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedTriangle<Real>
unfoldedApart(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
              const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3]) {
    UnfoldedTriangle<Real> result;
    for (int k = 0; k < 3; ++k) {
        const CrossingCorner<Real>& corner = corners[k];
        if (corner.isReleased) {
            result.offset[k] = corner.offset;
        } else if (!corner.isFree) {
            const ContactLine<Real> line = contactLine(body.field, frame, body.contactDistance,
                                                       cell, corner.held, middleOfFree(corners));
            if (line.found) {
                result.offset[k] =
                    unfolded(body.field, frame, body.contactDistance, cell, line, corner.held)
                        .position -
                    corner.plane;
                result.upwards[k] = line.upwards;
                result.steepness = std::fmin(result.steepness, line.steepness);
            }
        }
    }
    setEdges(triangle, corners, result);
    return result;
}

// All corners unfolded about one contact line.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedTriangle<Real>
unfoldedTogether(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
                 const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3]) {
    UnfoldedTriangle<Real> result;
    const ContactLine<Real> line = contactLine(body.field, frame, body.contactDistance, cell,
                                               middleOfHeld(corners), middleOfFree(corners));
    const Real perFree = Real(1) / Real(freeCount(corners));
    const Real perHeld = Real(1) / Real(3 - freeCount(corners));
    Real distance[3] = {}; // from the contact line: along the surface, or across the water
    Real floating(0), laid(0);
    for (int k = 0; k < 3 && line.found; ++k) {
        const CrossingCorner<Real>& corner = corners[k];
        if (corner.isFree) {
            distance[k] = std::fmax(dot(corner.plane - line.place, line.outwards), Real(0));
            floating += distance[k] * perFree;
        } else {
            const Unfolded<Real> place =
                unfolded(body.field, frame, body.contactDistance, cell, line, corner.held);
            result.offset[k] = place.position - corner.plane;
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

// Unfolds the surface under a triangle of which one or two corners are held. Where there is no
// contact line near (a flat face, a body that has gone under) its corners stay where they are.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedTriangle<Real>
unfoldedTriangle(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
                 const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3]) {
    const bool hasReleased =
        corners[0].isReleased || corners[1].isReleased || corners[2].isReleased;
    return hasReleased || detail::spansGap(body, frame, cell, corners)
               ? detail::unfoldedApart(body, frame, cell, triangle, corners)
               : detail::unfoldedTogether(body, frame, cell, triangle, corners);
}

// A triangle during a step: its corners when it begins and when it ends, held ones at their places
// at the beginning and at the end.
template <typename Real>
struct CrossingStep {
    double descent = 0, increment = 0; // of the body when it begins, and in it
    CrossingCorner<Real> before[3] = {}, after[3] = {};
};

// Adds the corners at which, in the step, the body has turned up past what film holds on: where
// they lay at the moment at which it had. `held` are the corners' places on the body, in its frame.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline void
releaseWhereTurnedUp(const ContactBody<Real>& body, Real cell, const TriangleCorners& triangle,
                     const CrossingStep<Real>& step, const Vector3<Real> (&held)[3],
                     ReleasedCorners<Real>& released) {
    const auto frameAt = [&](Real share) {
        return bodyFrame<Real>(body.motion, step.descent + step.increment * double(share));
    };
    const UnfoldedTriangle<Real> start =
        unfoldedTriangle(body, frameAt(Real(0)), cell, triangle, step.before);
    const UnfoldedTriangle<Real> end =
        unfoldedTriangle(body, frameAt(Real(1)), cell, triangle, step.after);
    for (int k = 0; k < 3; ++k) {
        if (!(end.upwards[k] > body.steepestHeld)) {
            continue;
        }
        Vector3<Real> offset = end.offset[k];
        if (start.upwards[k] > Real(-1) && start.upwards[k] < body.steepestHeld) {
            const Real share =
                (body.steepestHeld - start.upwards[k]) / (end.upwards[k] - start.upwards[k]);
            const BodyFrame<Real> frame = frameAt(share);
            CrossingCorner<Real> moment[3];
            for (int l = 0; l < 3; ++l) {
                moment[l] = step.after[l];
                moment[l].held = frame.toWorld(held[l]);
                if (moment[l].isFree) {
                    moment[l].plane =
                        step.before[l].plane + (step.after[l].plane - step.before[l].plane) * share;
                }
            }
            const UnfoldedTriangle<Real> then =
                unfoldedTriangle(body, frame, cell, triangle, moment);
            if (then.upwards[k] > Real(-1)) {
                offset = then.offset[k];
            }
        }
        released.x[k] = offset.x;
        released.z[k] = offset.z;
        released.isReleased[k] = true;
    }
}

} // namespace dipwright::pbd

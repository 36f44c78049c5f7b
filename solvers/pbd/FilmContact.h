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

// A film point that has met the body in a step.
template <typename Real>
struct Attachment {
    Vector3<Real> place; // body coordinates
    bool holds{};        // else it is caught by a face that turns up too far
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
        bodyFrame<Real>(body.motion, 0).directionToWorld(sampleField(body.field, place).gradient);
    return {place, !(gradient.y > body.steepestHeld * length(gradient))};
}

// A corner of a triangle that crosses the contact line.
template <typename Real>
struct CrossingCorner {
    bool isFree{};
    Vector3<Real> plane; // in the water plane
    Vector3<Real> held;  // held: in the world, on the body
};

template <typename Real>
struct UnfoldedTriangle {
    CrossingTriangle<Real> crossing; // but for its cell
    ContactLine<Real> line;
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

} // namespace detail

// The contact line under a triangle of which one or two corners are held.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline ContactLine<Real>
contactLineUnder(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
                 const CrossingCorner<Real> (&corners)[3]) {
    Vector3<Real> held, free;
    int heldCount = 0;
    for (const CrossingCorner<Real>& corner : corners) {
        held = corner.isFree ? held : held + corner.held;
        free = corner.isFree ? free + corner.plane : free;
        heldCount += corner.isFree ? 0 : 1;
    }
    return contactLine(body.field, frame, body.contactDistance, cell,
                       held * (Real(1) / Real(heldCount)), free * (Real(1) / Real(3 - heldCount)));
}

// The share of a step after which a triangle, at whose contact line the body turns up by `upwards`
// when the step ends, has come past what film holds on; `start`: its corners when the step begins.
// 1 where the line tells nothing.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real
shareUntilTurned(const ContactBody<Real>& body, const BodyFrame<Real>& startFrame, Real cell,
                 const CrossingCorner<Real> (&start)[3], Real upwards) {
    const ContactLine<Real> line = contactLineUnder(body, startFrame, cell, start);
    if (!line.found || !(upwards > body.steepestHeld)) {
        return Real(1);
    }
    return line.upwards < body.steepestHeld
               ? (body.steepestHeld - line.upwards) / (upwards - line.upwards)
               : Real(0);
}

// Unfolds the surface under a triangle of which one or two corners are held. Where there is no
// contact line near (a flat face, a body that has gone under) its corners stay where they are.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedTriangle<Real>
unfoldedTriangle(const ContactBody<Real>& body, const BodyFrame<Real>& frame, Real cell,
                 const TriangleCorners& triangle, const CrossingCorner<Real> (&corners)[3]) {
    UnfoldedTriangle<Real> result;
    result.line = contactLineUnder(body, frame, cell, corners);
    const ContactLine<Real>& line = result.line;

    const int freeCount = corners[0].isFree + corners[1].isFree + corners[2].isFree;
    const Real perHeld = Real(1) / Real(3 - freeCount), perFree = Real(1) / Real(freeCount);
    Vector3<Real> offset[3];
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
            offset[k] = place.position - corner.plane;
            distance[k] = place.path;
            laid += distance[k] * perHeld;
        }
    }
    const int shared = triangle.shared(), end = 1 - shared;
    const auto share = [&](int k, int l) {
        return detail::floatingShare(corners[k].isFree, distance[k], corners[l].isFree, distance[l],
                                     cell);
    };
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
    crossing.horizontalShare = share(shared, end);
    crossing.verticalShare = share(shared, 2);
    crossing.diagonalShare = share(end, 2);
    crossing.sharedFree = corners[shared].isFree;
    crossing.horizontalFree = corners[end].isFree;
    crossing.verticalFree = corners[2].isFree;
    crossing.normalX = line.outwards.x;
    crossing.normalZ = line.outwards.z;
    crossing.upwards = line.upwards;
    crossing.floating =
        floating + laid > Real(1e-6) * cell ? floating / (floating + laid) : Real(1);
    return result;
}

} // namespace dipwright::pbd

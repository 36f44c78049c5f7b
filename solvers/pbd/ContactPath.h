// The film between a point that has adhered and the waterline lies on the body's surface
// (film-physics §2.4). For the equilibrium in the water plane such a point stands where it would lie
// if that piece of surface were unfolded about the contact line: at its distance along the surface,
// inwards of the line.
#pragma once

#include "pbd/BodyFrame.h"
#include "pbd/FieldSampling.h"

namespace dipwright::pbd {

template <typename Real>
struct UnfoldedPoint {
    Real x{}, z{};     // in the water plane
    Real steepness{};  // horizontal share of the unit normal at the contact line: 0 flat, 1 vertical
    bool found{};      // false: no contact line near, the point stands where it is
};

// φ and its gradient in the world at a world point.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline FieldSample<Real>
sampleWorld(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Vector3<Real> p) {
    FieldSample<Real> sample = sampleField(field, frame.toBody(p));
    sample.gradient = frame.directionToWorld(sample.gradient);
    return sample;
}

namespace detail {

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real>
projectedOnSurface(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
                   Vector3<Real> p) {
    for (int iteration = 0; iteration < 3; ++iteration) {
        const FieldSample<Real> sample = sampleWorld(field, frame, p);
        const Real square = dot(sample.gradient, sample.gradient);
        if (square < Real(0.04)) {
            break;
        }
        p = p - sample.gradient * ((sample.distance - contactDistance) / square);
    }
    return p;
}

// The contact line near `start`, by Newton's method along the gradient in the water plane.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool
contactLineBySlope(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
                   Real cell, Vector3<Real> start, Vector3<Real>& line) {
    line = start;
    for (int iteration = 0; iteration < 12; ++iteration) {
        const FieldSample<Real> sample = sampleWorld(field, frame, line);
        const Real excess = sample.distance - contactDistance;
        if (std::abs(excess) < Real(1e-4) * cell) {
            return true;
        }
        const Vector3<Real> slope{sample.gradient.x, Real(0), sample.gradient.z};
        const Real square = dot(slope, slope);
        if (square < Real(0.0025)) {
            return false;
        }
        Vector3<Real> step = slope * (-excess / square);
        const Real size = length(step);
        if (size > cell) {
            step = step * (cell / size);
        }
        line = line + step;
    }
    return false;
}

// The contact line between `inside` (in the body) and `outside` (free water), by bisection.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool
contactLineBetween(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
                   Vector3<Real> inside, Vector3<Real> outside, Vector3<Real>& line) {
    const Real atInside = sampleWorld(field, frame, inside).distance - contactDistance;
    const Real atOutside = sampleWorld(field, frame, outside).distance - contactDistance;
    if (!(atInside <= Real(0) && atOutside > Real(0))) {
        return false;
    }
    for (int iteration = 0; iteration < 20; ++iteration) {
        line = (inside + outside) * Real(0.5);
        if (sampleWorld(field, frame, line).distance > contactDistance) {
            outside = line;
        } else {
            inside = line;
        }
    }
    return true;
}

} // namespace detail

// `point`: the adhered point, body coordinates. `towards`: the middle of its free neighbours in the
// water plane, used where the surface at the point is too flat to say where the waterline is.
// `cell`: the film's spacing.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline UnfoldedPoint<Real>
unfoldedPoint(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
              Real cell, Vector3<Real> point, Vector3<Real> towards) {
    const Vector3<Real> p = frame.toWorld(point);
    const Vector3<Real> above{p.x, Real(0), p.z};
    Vector3<Real> line;
    if (!detail::contactLineBySlope(field, frame, contactDistance, cell, above, line) &&
        !detail::contactLineBetween(field, frame, contactDistance, above, towards, line)) {
        return {p.x, p.z, Real(1), false};
    }
    const Vector3<Real> gradient = sampleWorld(field, frame, line).gradient;
    const Real horizontal = std::sqrt(gradient.x * gradient.x + gradient.z * gradient.z);
    const Real size = length(gradient);
    if (horizontal < Real(0.02) * size) {
        return {p.x, p.z, Real(0), false};
    }
    // The way along the surface: chord, and two chords over the projected middle; the difference of
    // the two tells the arc to fourth order (Richardson).
    const Real chord = length(line - p);
    const Vector3<Real> middle =
        detail::projectedOnSurface(field, frame, contactDistance, (p + line) * Real(0.5));
    const Real chords = length(middle - p) + length(line - middle);
    Real path = chords + (chords - chord) / Real(3);
    path = path < Real(2) * chord ? path : Real(2) * chord;
    return {line.x - path * gradient.x / horizontal, line.z - path * gradient.z / horizontal,
            horizontal / size, true};
}

} // namespace dipwright::pbd

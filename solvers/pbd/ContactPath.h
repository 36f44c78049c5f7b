// The film between a point that has adhered and the waterline lies on the body's surface
// (film-physics §2.4). For the equilibrium in the water plane, every triangle that crosses the
// contact line sees its adhered corners where they would lie if that piece of surface were unfolded
// about the line: at their distance along the surface, inwards of it. Each triangle unfolds by
// itself; at a sharp tip one adhered point lies in a different place for each triangle round it.
#pragma once

#include "pbd/BodyFrame.h"
#include "pbd/FieldSampling.h"

namespace dipwright::pbd {

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

// The contact line of one film triangle, taken as straight: a point on it, the unit vector across
// it in the water plane, away from the body, and how steep the surface is there.
template <typename Real>
struct ContactLine {
    Vector3<Real> place;
    Vector3<Real> outwards;
    Real steepness{}; // horizontal share of the unit normal: 0 flat, 1 vertical
    Real upwards{};   // vertical share of the unit normal: above 0 past the equator
    bool found{};
};

// `adhered` and `free`: the middles of the triangle's adhered corners (at their true places) and of
// its free ones. `cell`: the film's spacing.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline ContactLine<Real>
contactLine(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
            Real cell, Vector3<Real> adhered, Vector3<Real> free) {
    const Vector3<Real> above{adhered.x, Real(0), adhered.z};
    ContactLine<Real> line;
    if (!detail::contactLineBetween(field, frame, contactDistance, above, free, line.place) &&
        !detail::contactLineBySlope(field, frame, contactDistance, cell, above, line.place)) {
        return line;
    }
    const Vector3<Real> gradient = sampleWorld(field, frame, line.place).gradient;
    const Real horizontal = std::sqrt(gradient.x * gradient.x + gradient.z * gradient.z);
    const Real size = length(gradient);
    line.found = horizontal > Real(0.02) * size;
    if (line.found) {
        line.outwards = {gradient.x / horizontal, Real(0), gradient.z / horizontal};
        line.steepness = horizontal / size;
        line.upwards = gradient.y / size;
    }
    return line;
}

template <typename Real>
struct Unfolded {
    Vector3<Real> position; // in the water plane
    Real path{};            // mm along the surface to the contact line
};

// Where an adhered corner at world point `corner` lies when its piece of surface is unfolded about
// `line`: it keeps its place along the line and stands inwards of it by its distance along the
// surface.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Unfolded<Real>
unfolded(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
         Real cell, const ContactLine<Real>& line, Vector3<Real> corner) {
    const Vector3<Real> above{corner.x, Real(0), corner.z};
    // From above the corner across to the contact line: Newton's method along `outwards`.
    Real across = dot(line.place - above, line.outwards);
    for (int iteration = 0; iteration < 6; ++iteration) {
        const FieldSample<Real> sample = sampleWorld(field, frame, above + line.outwards * across);
        const Real slope = dot(sample.gradient, line.outwards);
        if (slope < Real(0.02)) {
            break;
        }
        const Real step = (contactDistance - sample.distance) / slope;
        across += std::fmin(std::fmax(step, -cell), cell);
    }
    const Vector3<Real> foot = above + line.outwards * across;
    // The way along the surface: chord, and two chords over the projected middle; the difference of
    // the two tells the arc to fourth order (Richardson).
    const Real chord = length(foot - corner);
    const Vector3<Real> middle =
        detail::projectedOnSurface(field, frame, contactDistance, (corner + foot) * Real(0.5));
    const Real chords = length(middle - corner) + length(foot - middle);
    const Real path = std::fmin(chords + (chords - chord) / Real(3), Real(2) * chord);
    return {foot - line.outwards * path, path};
}

} // namespace dipwright::pbd

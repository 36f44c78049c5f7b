// The film between a point that has adhered and the waterline lies on the body's surface
// (docs/film-model.md, "At the contact line"). For the equilibrium in the water plane, every
// triangle that crosses the contact line sees its adhered corners where they would lie if that
// piece of surface were unfolded about the line: at their distance along the surface, inwards of
// it, across the line where it is nearest. At a sharp tip one adhered point lies in a different
// place for each triangle round it.
#pragma once

#include "common/BodyFrame.h"
#include "common/FieldSampling.h"
#include "production/formulas/Tolerances.h"

namespace dipwright::numerics {

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
    for (int iteration = 0; iteration < surfaceNewtonSteps; ++iteration) {
        const FieldSample<Real> sample = sampleWorld(field, frame, p);
        const Real square = dot(sample.gradient, sample.gradient);
        if (square < Real(leastGradientSquared)) {
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
    for (int iteration = 0; iteration < contactLineNewtonSteps; ++iteration) {
        const FieldSample<Real> sample = sampleWorld(field, frame, line);
        const Real excess = sample.distance - contactDistance;
        if (std::abs(excess) < Real(contactLineReached) * cell) {
            return true;
        }
        const Vector3<Real> slope{sample.gradient.x, Real(0), sample.gradient.z};
        const Real square = dot(slope, slope);
        if (square < Real(leastPlaneSlopeSquared)) {
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
    for (int iteration = 0; iteration < contactLineHalvings; ++iteration) {
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
    const Vector3<Real> gradient =
        frame.directionToWorld(smoothGradient(field, frame.toBody(line.place)));
    const Real horizontal = std::sqrt(gradient.x * gradient.x + gradient.z * gradient.z);
    const Real size = length(gradient);
    line.found = horizontal > Real(leastSlope) * size;
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

namespace detail {

// From `above`, over the body, across to the contact line: Newton's method along `outwards`, from
// the distance `across`.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real
acrossToLine(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
             Real cell, Vector3<Real> above, Vector3<Real> outwards, Real across) {
    for (int iteration = 0; iteration < acrossLineNewtonSteps; ++iteration) {
        const FieldSample<Real> sample = sampleWorld(field, frame, above + outwards * across);
        const Real slope = dot(sample.gradient, outwards);
        if (slope < Real(leastSlope)) {
            break;
        }
        const Real step = (contactDistance - sample.distance) / slope;
        across += std::fmin(std::fmax(step, -cell), cell);
    }
    return across;
}

// The least cosine between a corner's own direction across the contact line and its triangle's.
inline constexpr double leastAgreement = 0.5;

} // namespace detail

// Where an adhered corner at world point `corner` lies when its piece of surface is unfolded about
// the contact line: inwards of it by its distance along the surface, across the line where it is
// nearest to the corner. So the film there is drawn in, whatever triangle sees it: were all corners
// of a triangle unfolded along the normal of `line`, they would be wrenched aside with every change
// of it, and the film with them. The nearest place is taken to be where the line's own normal,
// found straight across from the corner, leads to; right above a tip, where all ways are as short,
// it stays the triangle's.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Unfolded<Real>
unfolded(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
         Real cell, const ContactLine<Real>& line, Vector3<Real> corner) {
    const Vector3<Real> above{corner.x, Real(0), corner.z};
    Vector3<Real> outwards = line.outwards;
    Real across = detail::acrossToLine(field, frame, contactDistance, cell, above, outwards,
                                       dot(line.place - above, outwards));
    const Vector3<Real> gradient =
        frame.directionToWorld(smoothGradient(field, frame.toBody(above + outwards * across)));
    const Real horizontal = std::sqrt(gradient.x * gradient.x + gradient.z * gradient.z);
    const Vector3<Real> normal{gradient.x / horizontal, Real(0), gradient.z / horizontal};
    if (horizontal > Real(leastSlope) &&
        dot(normal, line.outwards) > Real(detail::leastAgreement)) {
        outwards = normal;
        across = detail::acrossToLine(field, frame, contactDistance, cell, above, outwards, across);
    }
    const Vector3<Real> foot = above + outwards * across;
    // The way along the surface: chord, and two chords over the projected middle; the difference of
    // the two tells the arc to fourth order (Richardson).
    const Real chord = length(foot - corner);
    const Vector3<Real> middle =
        detail::projectedOnSurface(field, frame, contactDistance, (corner + foot) * Real(0.5));
    const Real chords = length(middle - corner) + length(foot - middle);
    const Real path = std::fmin(chords + (chords - chord) / Real(3), Real(2) * chord);
    return {foot - outwards * path, path};
}

} // namespace dipwright::numerics

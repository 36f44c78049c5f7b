// Unfolds the body's surface with the adhered film on it, from the contact line into the water
// plane (docs/film-model.md, "At the contact line"). The equilibrium in the water plane needs this
// for each triangle that crosses the contact line. The unfolding puts an adhered corner on the
// body's side of the line, opposite the line's nearest point. There its distance from the line is
// what it was along the surface. At a sharp tip, an adhered point gets a different place for each
// triangle around it.
#pragma once

#include "common/BodyFrame.h"
#include "common/FieldSampling.h"
#include "common/Lanes.h"
#include "common/RootBetween.h"
#include "production/formulas/Tolerances.h"

namespace dipwright::numerics {

// Returns φ and its gradient in world coordinates at a world point.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_IN_LOOP FieldSample<Real>
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

// Returns smoothGradient(); each lane computes one component.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real> gradientInLanes(const FieldGrid<Real>& field,
                                                           Vector3<Real> position) {
    if constexpr (Lanes::count < 3) {
        return smoothGradient(field, position);
    } else {
        const Real own = smoothSlope(field, position, Lanes::index());
        return {Lanes::from(own, 0), Lanes::from(own, 1), Lanes::from(own, 2)};
    }
}

// Finds the contact line near `start` by Newton's method, along the gradient in the water plane.
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

// Finds the contact line between `inside` (within the body) and `outside` (in free water).
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline bool
contactLineBetween(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
                   Vector3<Real> inside, Vector3<Real> outside, Vector3<Real>& line) {
    const auto excessAt = [&](Real share) {
        line = inside + (outside - inside) * share;
        return sampleWorld(field, frame, line).distance - contactDistance;
    };
    const Real within = excessAt(Real(0)), beyond = excessAt(Real(1));
    const bool isBetween = within <= Real(0) && beyond > Real(0);
    if (isBetween) {
        rootBetween(excessAt, within, beyond);
    }
    return isBetween;
}

} // namespace detail

// The contact line at one film triangle, approximated as straight: a point on the line, the line's
// unit normal in the water plane, which points away from the body, and the slope of the surface
// there.
template <typename Real>
struct ContactLine {
    Vector3<Real> place;
    Vector3<Real> outwards;
    Real steepness{}; // horizontal component of the unit normal: 0 flat, 1 vertical
    Real upwards{};   // vertical component of the unit normal: positive past the equator
    bool found{};
};

// `adhered` is the mean of the triangle's adhered corners at their real places, `free` the mean of
// its free corners. `cell` is the film's spacing.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_CALLED ContactLine<Real>
contactLine(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
            Real cell, Vector3<Real> adhered, Vector3<Real> free) {
    const Vector3<Real> above{adhered.x, Real(0), adhered.z};
    ContactLine<Real> line;
    if (!detail::contactLineBetween(field, frame, contactDistance, above, free, line.place) &&
        !detail::contactLineBySlope(field, frame, contactDistance, cell, above, line.place)) {
        return line;
    }
    const Vector3<Real> gradient =
        frame.directionToWorld(detail::gradientInLanes(field, frame.toBody(line.place)));
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
    Real path{};            // distance to the contact line along the surface, mm
};

namespace detail {

// Returns the distance from `above` along `outwards`, over the body, to the contact line. Newton's
// method starts at the distance `across`.
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
        if (std::abs(step) < Real(acrossLineFound) * cell) {
            break;
        }
    }
    return across;
}

// The normal of the contact line at a corner is used if the cosine of its angle to the triangle's
// normal exceeds this.
inline constexpr double leastAgreement = 0.5;

} // namespace detail

// Returns where an adhered corner at the world point `corner` lies after unfolding about the
// contact line. First finds the line's point that is nearest to the corner; the line's normal there
// passes through the corner. From that point, the result lies towards the body, at the distance
// along the surface. So all triangles that share the corner unfold it in the same direction. The
// triangle's normal (`line`) would move the corner sideways whenever that normal changes. Directly
// above a tip, the line is equally near in all directions; there the triangle's normal is used.
template <typename Real>
DIPWRIGHT_HOST_DEVICE DIPWRIGHT_CALLED Unfolded<Real>
unfolded(const FieldGrid<Real>& field, const BodyFrame<Real>& frame, Real contactDistance,
         Real cell, const ContactLine<Real>& line, Vector3<Real> corner) {
    const Vector3<Real> above{corner.x, Real(0), corner.z};
    Vector3<Real> outwards = line.outwards;
    Real across = detail::acrossToLine(field, frame, contactDistance, cell, above, outwards,
                                       dot(line.place - above, outwards));
    const Vector3<Real> gradient = frame.directionToWorld(
        detail::gradientInLanes(field, frame.toBody(above + outwards * across)));
    const Real horizontal = std::sqrt(gradient.x * gradient.x + gradient.z * gradient.z);
    const Vector3<Real> normal{gradient.x / horizontal, Real(0), gradient.z / horizontal};
    if (horizontal > Real(leastSlope) &&
        dot(normal, line.outwards) > Real(detail::leastAgreement)) {
        outwards = normal;
        across = detail::acrossToLine(field, frame, contactDistance, cell, above, outwards, across);
    }
    const Vector3<Real> foot = above + outwards * across;
    // The length along the surface, computed from one chord and from two chords over the projected
    // midpoint. Richardson extrapolation makes the length correct to fourth order.
    const Real chord = length(foot - corner);
    const Vector3<Real> middle =
        detail::projectedOnSurface(field, frame, contactDistance, (corner + foot) * Real(0.5));
    const Real chords = length(middle - corner) + length(foot - middle);
    const Real path = std::fmin(chords + (chords - chord) / Real(3), Real(2) * chord);
    return {foot - outwards * path, path};
}

} // namespace dipwright::numerics

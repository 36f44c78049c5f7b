// Converts between body and world coordinates at one moment of the dip (FilmSolver.h, BodyMotion).
#pragma once

#include "common/Vector3.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::numerics {

// A rigid transformation: the body point q lies at rotation·q + translation in the world.
template <typename Real>
struct BodyFrame {
    Vector3<Real> rows[3]; // rows of the rotation matrix
    Vector3<Real> translation;

    DIPWRIGHT_HOST_DEVICE Vector3<Real> directionToWorld(Vector3<Real> d) const {
        return {dot(rows[0], d), dot(rows[1], d), dot(rows[2], d)};
    }
    DIPWRIGHT_HOST_DEVICE Vector3<Real> directionToBody(Vector3<Real> d) const {
        return rows[0] * d.x + rows[1] * d.y + rows[2] * d.z;
    }
    DIPWRIGHT_HOST_DEVICE Vector3<Real> toWorld(Vector3<Real> q) const {
        return directionToWorld(q) + translation;
    }
    DIPWRIGHT_HOST_DEVICE Vector3<Real> toBody(Vector3<Real> p) const {
        return directionToBody(p - translation);
    }
};

// Returns the frame after the body has descended by `descent` mm.
template <typename Real>
DIPWRIGHT_HOST_DEVICE BodyFrame<Real> bodyFrame(const solver::BodyMotion& motion, double descent) {
    const auto& r = motion.rotation;
    BodyFrame<Real> frame;
    for (int row = 0; row < 3; ++row) {
        frame.rows[row] = {Real(r[3 * row]), Real(r[3 * row + 1]), Real(r[3 * row + 2])};
    }
    frame.translation = {Real(motion.start[0]), Real(motion.start[1] - descent),
                         Real(motion.start[2])};
    return frame;
}

} // namespace dipwright::numerics

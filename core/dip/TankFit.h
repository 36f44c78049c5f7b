// Tells whether a tank and its machine can carry out a dip.
#pragma once

#include "dip/BodyPath.h"
#include "settings/Profile.h"

#include <QString>

#include <vector>

namespace dipwright {

// Returns where the origin of a path's frame (dip/BodyPath.h) is in the frame of the tank, in mm,
// `time` after the dip began. The film flows with the water, and the path's frame with the film.
Eigen::Vector3d pathOriginInTank(const Immersion& immersion, Seconds time);

// A limit of the tank that a dip exceeds.
struct TankFault {
    QString sentence;            // for the user, without full stop
    double value = 0, limit = 0; // what the dip needs and what the tank has, in mm, mm/s or °/s
};

// Returns each limit of the tank that film or part exceeds: barriers that hold the film's edges,
// and with a profile its walls, its floor, and the reach and the speeds of its machine. The middle
// of the film, as large as it is when the dip begins, floats over the middle of the tank. `posed`
// is the body in its pose frame (dip/Pose.h), `path` its path there. Not checked: how the machine
// turns the part over the water before the dip.
std::vector<TankFault> tankFaults(const std::optional<TankProfile>& profile,
                                  const FilmSettings& film, const ProcessSettings& process,
                                  const Immersion& immersion, const TriangleMesh& posed,
                                  const solver::BodyPath& path);
// Returns the sentences in one line.
QString textOf(const std::vector<TankFault>& faults);

} // namespace dipwright

// The three pins that fix the place of a job's sheets, tank frame and cradles to each other.
#pragma once

#include "base/Units.h"

#include <Eigen/Core>
#include <array>

namespace dipwright {

struct FilmSettings;
struct Sheet;

// Places on the water in the world frame (dip/Pose.h), x and z: those of the sheet's registration
// marks upper left, upper right and lower left, when the film has swollen to its size. Three of
// four, so that nothing goes on turned round.
struct DatumPins {
    std::array<Eigen::Vector2d, 3> marks; // of the floating sheet
    // On the same lines from the film's middle, drawn in where a plate would become too large.
    std::array<Eigen::Vector2d, 3> pins;
    double share = 1; // of the way from the middle to the marks that the pins are at
};

// The same for all immersions of a job. `farthest`: mm between two pins along x or z at most.
DatumPins datumPins(const Sheet& sheet, const FilmSettings& film, Millimetres farthest);

} // namespace dipwright

// Computes the three pins that align a job's sheets, tank frame and cradles with each other.
#pragma once

#include "base/Units.h"

#include <Eigen/Core>
#include <array>

namespace dipwright {

struct FilmSettings;
struct Sheet;

// Positions on the water in the world frame (dip/Pose.h), x and z, mm. They correspond to the
// sheet's registration marks upper left, upper right and lower left, after the film has swollen. If
// the sheet has no marks on the film, they correspond to the film's corners. With three pins
// instead of four, nothing can be mounted the wrong way round.
struct DatumPins {
    std::array<Eigen::Vector2d, 3> marks; // marks or corners of the floating sheet
    // The pins lie on the lines from the film's middle to the marks. They are closer to the middle
    // than the marks if the plate would otherwise be too large.
    std::array<Eigen::Vector2d, 3> pins;
    // Distance of the pins from the middle, as a share of the distance of the marks.
    double share = 1;
};

// Returns the pins, which are the same for all dips of a job. `farthest` is the largest distance
// between two pins along x or z.
DatumPins datumPins(const Sheet& sheet, const FilmSettings& film, Millimetres farthest);

} // namespace dipwright

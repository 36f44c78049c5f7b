// Describes a place of the printed sheet that was found in a photo of a dipped part.
#pragma once

#include <Eigen/Core>

namespace dipwright {

struct PrintedPlace {
    int photo = 0;         // index of the photo
    Eigen::Vector2d pixel; // where the photo shows the place, as in Lens.h
    int dip = 0;           // index of the dip whose film carried the place
    // Where the place was printed, in mm from the sheet's middle, rightwards and downwards on the
    // floating sheet, ink side up. Equals restPosition() (DippedFilm.h) divided by the swell.
    Eigen::Vector2d sheet;
    Eigen::Vector3d model; // intended place on the part, mm, in the project's model coordinates
};

} // namespace dipwright

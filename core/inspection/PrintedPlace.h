// Describes a place of the printed sheet that was found in a photo of a dipped part.
#pragma once

#include <Eigen/Core>

namespace dipwright {

struct PrintedPlace {
    int photo = 0;         // index of the photo
    Eigen::Vector2d pixel; // where it is seen, as in Lens.h
    int dip = 0;           // index of the dip whose film carried it
    // Where it was printed: mm from the sheet's middle, to the right and down the sheet as it
    // floats with its ink up. This is restPosition() (DippedFilm.h) divided by the swell.
    Eigen::Vector2d sheet;
    Eigen::Vector3d model; // its intended place on the part: mm, in the project's model coordinates
};

} // namespace dipwright

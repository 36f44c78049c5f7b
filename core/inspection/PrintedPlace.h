// A place of the printed sheet that was found in a photo of a dipped part.
#pragma once

#include <Eigen/Core>

namespace dipwright {

struct PrintedPlace {
    int photo = 0;         // index of the photo
    Eigen::Vector2d pixel; // where it is seen, as in Lens.h
    int dip = 0;           // index of the project's immersion whose film it was printed on
    // Where it was printed, mm from the sheet's middle, to the right and down the sheet as it
    // floats with its ink up: restPosition() (DippedFilm.h) over the swell.
    Eigen::Vector2d sheet;
    Eigen::Vector3d model; // where on the part it is meant to be: mm, as the project has the model
};

} // namespace dipwright

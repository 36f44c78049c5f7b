// Draws one picture of the part as it will come out, for lists of projects.
#pragma once

#include "results/Results.h"

namespace dipwright {

// Draws the painted body like a proof, but from one side and without text. `towards` is the
// direction from the body to the camera, in model coordinates; it is limited to angles at which the
// body stands upright. Uses all cores, without OpenGL. Throws Cancelled.
QImage portraitPicture(const ProofStage& stage, const std::vector<FilmAppearance>& films,
                       const ProofOptions& options, const Eigen::Vector3f& towards,
                       const CancelToken& cancelToken);

} // namespace dipwright

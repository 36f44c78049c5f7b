// The sheet of one immersion: its film image with the job line that tells it from every other.
#pragma once

#include "dip/Pose.h"
#include "project/Project.h"

namespace dipwright {

// `white`: the tints of its white layer, Grayscale8, not choked yet; may be null.
Sheet jobSheet(const Project& project, const Immersion& immersion, const QImage& filmImage,
               const QImage& white = {});

} // namespace dipwright

// The sheet of one immersion: its film image with the job line that tells it from every other.
#pragma once

#include "dip/Pose.h"
#include "project/Project.h"

namespace dipwright {

Sheet jobSheet(const Project& project, const Immersion& immersion, const QImage& filmImage);

} // namespace dipwright

// The sheet of one immersion: its film image with the job line that tells it from every other.
#pragma once

#include "dip/Pose.h"
#include "project/Project.h"

namespace dipwright {

// What is printed on a film; all but the colours may be null.
struct PrintedFilm {
    QImage colours;
    QImage white = {};                // tints of the white layer, Grayscale8, not choked yet
    QImage wanted = {}, stretch = {}; // as of WantedInk (sheet/Sheet.h)
};

Sheet jobSheet(const Project& project, const Immersion& immersion, const PrintedFilm& film);

} // namespace dipwright

// The sheet of one immersion: its film image with the job line that tells it from every other.
#pragma once

#include "base/Progress.h"
#include "sheet/page/Sheet.h"

namespace dipwright {

struct Project;
struct Immersion;

// What is printed on a film; all but the colours may be null.
struct PrintedFilm {
    QImage colours;
    QImage white = {};                // tints of the white layer, Grayscale8, not choked yet
    QImage wanted = {}, stretch = {}; // as of WantedInk (sheet/page/Sheet.h)
    std::vector<QImage> spots = {};   // tints of the artwork's spot inks, in their order
};

// Throws Error where two plates of a sheet had one name, or the artwork has too many.
void checkSpots(const Project& project);

// Throws Cancelled.
Sheet jobSheet(const Project& project, const Immersion& immersion, const PrintedFilm& film,
               const CancelToken& user = {});

} // namespace dipwright

// Makes the sheet of one dip: the film image and the job line that identifies it.
#pragma once

#include "base/Progress.h"
#include "sheet/page/Sheet.h"

namespace dipwright {

struct Project;
struct Immersion;

// The images printed on a film. All except `colours` may be null.
struct PrintedFilm {
    QImage colours;
    QImage white = {};                // tints of the white layer, Grayscale8, before choking
    QImage wanted = {}, stretch = {}; // as in WantedInk (sheet/page/Sheet.h)
    InkPlanes inks = {};              // as in WantedInk
    std::vector<QImage> spots = {};   // tints of the artwork's spot colours, in their order
};

// Throws Error if two plates of a sheet would have the same name, or if the artwork has too many
// spot colours.
void checkSpots(const Project& project);
// Does the same for an edited project, unless the project had such a fault before the edit: faults
// of an opened file can then be repaired one by one.
void checkEditedSpots(const Project& before, const Project& after);

// Returns Sheet::clearance of the project's sheets: their marks are clear of the margins of the
// project's printer profile. Traveller and cradle have their pins at these marks.
Millimetres markClearance(const Project& project);

// Makes the sheet. Throws Cancelled.
Sheet jobSheet(const Project& project, const Immersion& immersion, const PrintedFilm& film,
               const CancelToken& user = {});

} // namespace dipwright

// A dipped part as it was measured by its photos: by found corners, or by the clicked pairs alone.
#pragma once

#include "dip/LaidFilm.h"
#include "inspection/FindPrint.h"
#include "inspection/PartViewFiles.h"
#include "project/Project.h"

#include <memory>

namespace dipwright {

struct MeasuredPart {
    Project project; // as it was then
    std::vector<PartPhoto> photos;
    std::vector<PlacePair> pairs;
    std::vector<PrintedPlace> places; // of those found; else empty
    std::vector<int> expected;        // corners of each photo
    bool followsPrint = false;
    PartView view;
    std::vector<std::shared_ptr<const LaidFilm>> dips; // that found places were held against
};

std::vector<PlacePair> clickedPairs(const InspectedPart& part);
// The found places where they were printed: on a sheet that was corrected beside where the film was
// made.
std::vector<PrintedPlace> printedOnSheet(const MeasuredPart& measured);

} // namespace dipwright

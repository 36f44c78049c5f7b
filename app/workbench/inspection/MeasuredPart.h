// A dipped part that was measured by photos: by its corners, or by the clicked pairs alone.
#pragma once

#include "dip/LaidFilm.h"
#include "inspection/FindPrint.h"
#include "inspection/PartViewFiles.h"
#include "project/Project.h"

#include <memory>

namespace dipwright {

struct MeasuredPart {
    Project project; // at the time of the measurement
    std::vector<PartPhoto> photos;
    std::vector<PlacePair> pairs;
    std::vector<PrintedPlace> places; // the corners that were found
    std::vector<int> expected;        // number of corners in each photo
    QString doubt;                    // see FoundPrint
    bool followsPrint = false;
    PartView view;
    std::vector<std::shared_ptr<const LaidFilm>> dips; // the simulated films for comparison
};

std::vector<PlacePair> clickedPairs(const InspectedPart& part);
// Returns the found corners at their places on the printed sheet. A corrected sheet shows the
// corners at other places than the simulated film.
std::vector<PrintedPlace> printedOnSheet(const MeasuredPart& measured);

} // namespace dipwright

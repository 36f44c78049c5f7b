#include "workbench/inspection/MeasuredPart.h"

#include "inspection/BuiltPlaces.h"
#include "project/DipKeys.h"

namespace dipwright {

std::vector<PlacePair> clickedPairs(const InspectedPart& part) {
    std::vector<PlacePair> pairs;
    for (const ClickedPair& pair : part.pairs) {
        pairs.push_back({pair.photo,
                         {pair.pixel[0], pair.pixel[1]},
                         {pair.place[0].value(), pair.place[1].value(), pair.place[2].value()}});
    }
    return pairs;
}

std::vector<PrintedPlace> printedOnSheet(const MeasuredPart& measured) {
    return measured.project.inspection.chessboard
               ? measured.places
               : onPrintedSheet(measured.places, partsDippedAlike(measured.project));
}

} // namespace dipwright

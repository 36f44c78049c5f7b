// How the sheets of two states differ, dip by dip: values, a map of the sheet, colours of the body.
#pragma once

#include "accuracy/error/SheetDifference.h"
#include "workbench/appearance/BodyAppearance.h"
#include "workbench/widgets/HeatScale.h"
#include "workbench/widgets/Units.h"

namespace dipwright {

struct DipDifference {
    SheetDifference sheets;
    HeatScale scale;          // of map and body, mm
    QImage map;               // differenceMap() of the second state
    BodyAppearance body;      // coloured by the difference
    Eigen::Vector3f farthest; // place of the largest difference, in model coordinates
};

// Two results of the same model with the same number of dips.
using ComparedResults = std::array<std::shared_ptr<const JobResult>, 2>;

// Returns a sentence that says why the sheets of two results cannot be compared; empty if they can.
QString incomparableSentence(const ComparedResults& results);

// Compares the dips of two comparable results by their numbers. Any thread; throws Cancelled.
std::vector<DipDifference> stateDifference(const ComparedResults& results, LengthUnit unit,
                                           const Progress& progress);

} // namespace dipwright

// Whether two projects come to the same sheets.
#pragma once

namespace dipwright {

struct Project;

// By the inputs of the usual run of either (StepInputs.h): the projects differ, if at all, in what
// no step depends on, such as snapshots.
bool makeSameSheets(const Project& first, const Project& second);

} // namespace dipwright

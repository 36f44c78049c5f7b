// Tells whether two projects make the same sheets.
#pragma once

namespace dipwright {

struct Project;

// Compares the inputs of a default run of each (StepInputs.h). Values that no step depends on, such
// as snapshots, may differ.
bool makeSameSheets(const Project& first, const Project& second);

} // namespace dipwright

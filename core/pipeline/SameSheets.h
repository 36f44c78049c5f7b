// Tells whether two projects make the same sheets.
#pragma once

namespace dipwright {

struct Project;

// Tells whether runs of both projects with default options would have equal inputs (StepInputs.h).
// Values that no step depends on, such as snapshots, may differ.
bool makeSameSheets(const Project& first, const Project& second);

} // namespace dipwright

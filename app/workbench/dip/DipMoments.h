// Finds the notable moments of a dip.
#pragma once

#include "pipeline/JobResult.h"
#include "workbench/dip/DipRecording.h"

namespace dipwright {

enum class DipEvent { FirstContact, AirTrapped, Torn, LetGo };

struct DipMoment {
    DipEvent event;
    double descent = 0; // mm, as in RecordedFrame
};

// Returns the first moment of each event that happened, in order of time. Torn and LetGo (released
// film) are as precise as the interval between the recorded frames.
std::vector<DipMoment> dipMoments(const DipRecording& recording, const ImmersionResult& result);

} // namespace dipwright

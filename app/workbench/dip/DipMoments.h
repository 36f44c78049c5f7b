// The moments of a dip that are worth a look.
#pragma once

#include "pipeline/JobResult.h"
#include "workbench/dip/DipRecording.h"

namespace dipwright {

enum class DipEvent { FirstContact, AirCaught, Torn, LetGo };

struct DipMoment {
    DipEvent event;
    double descent = 0; // mm, as RecordedFrame's
};

// In the order in which they come; of each event the first, and none that did not happen. When film
// tore or was let go of is told as finely as the recording's frames came.
std::vector<DipMoment> dipMoments(const DipRecording& recording, const ImmersionResult& result);

} // namespace dipwright

// The verdict on a whole job: of its dips, and of what is told of them together.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// The zones that the project marks on its body; null where it marks none.
std::shared_ptr<const ZonedBody> markedZones(const Project& project);

// Of a dip whose film is laid, measured and printed. `zones`: markedZones().
Verdict dipVerdict(const ImmersionResult& dip, const Project& project, const ZonedBody* zones);

// Of all dips together: what JobResult::verdict is. `zones`: markedZones().
Verdict togetherVerdict(const JobResult& result, const ZonedBody* zones);

// A reason and the dip that it is of; none: all of them.
struct JobReason {
    std::optional<std::size_t> dip;
    VerdictReason reason;
};

// The worst of the dips' advice and of what is told of them together, and all reasons, the worst
// first.
Advice adviceOf(const JobResult& result);
std::vector<JobReason> reasonsOf(const JobResult& result);

// For the user: "Top: Trapped air keeps …". `length` words a length given in mm.
QString reasonText(const JobReason& reason, const JobResult& result, const LengthText& length);

} // namespace dipwright

// Judges a whole job: each dip, and all dips together.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// Returns the zones marked in the project; null if there are none.
std::shared_ptr<const ZonedBody> markedZones(const Project& project);

// Judges a dip whose film is laid and measured and whose sheet is made. `zones`: markedZones().
Verdict dipVerdict(const ImmersionResult& dip, const Project& project, const ZonedBody* zones);

// Judges all dips together, for JobResult::verdict. `zones`: markedZones().
Verdict allDipsVerdict(const JobResult& result, const ZonedBody* zones);

// A reason and the dip that it is about; without a dip it is about all.
struct JobReason {
    std::optional<std::size_t> dip;
    VerdictReason reason;
};

// Returns the worst verdict of the dips and of all together, and all reasons, the worst first.
Advice adviceOf(const JobResult& result);
std::vector<JobReason> reasonsOf(const JobResult& result);

// A sentence for the user: "Top: Trapped air keeps …". `length` formats mm.
QString reasonText(const JobReason& reason, const JobResult& result, const LengthText& length);

} // namespace dipwright

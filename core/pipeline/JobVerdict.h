// Judges a whole job: each dip, and all dips together.
#pragma once

#include "pipeline/JobResult.h"

namespace dipwright {

// Returns the verdict on a dip. Its film must be laid and measured, and its sheet made.
Verdict dipVerdict(const ImmersionResult& dip, const Project& project,
                   const JudgedSurface& surface);

// Returns the verdict on all dips together, for JobResult::verdict. `zones` is the result of
// markedZones().
Verdict allDipsVerdict(const JobResult& result, const ZonedBody* zones);

// Returns the places that neither of two dips paints, without masked places; the largest first.
std::vector<UnpaintedPlace> unreachedPlaces(const JobResult& result);

// A reason and the dip that it is about. Without a dip, the reason is about all dips together.
struct JobReason {
    std::optional<std::size_t> dip;
    VerdictReason reason;
};

// Returns the worst advice in the verdicts on each dip and on all dips together.
Advice adviceOf(const JobResult& result);
// Returns all reasons, the worst first.
std::vector<JobReason> reasonsOf(const JobResult& result);

// Returns a sentence for the user: "Top: Trapped air keeps …". `length` formats mm.
QString reasonText(const JobReason& reason, const JobResult& result, const LengthText& length);
// Returns the advice, a line for each reason with another advice than Advice::Print, and a line for
// each of the job's notes except refinementRemarks().
QStringList warningLines(const JobResult& result, const LengthText& length);

} // namespace dipwright

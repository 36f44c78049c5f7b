// What the dips of a project have come to, kept beside its file, so that whoever opens it sees its
// results without dipping again.
//
// The file is a zip with an entry for each dip, the newest last, named by a hash of all that the
// dip depends on: dips of earlier states of the project stay until there is no room for them. What
// else a result has is made anew of the films (docs/files-and-commands.md, "Kept dips").
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Of all dips of a project: what is older goes.
inline constexpr qint64 mostCacheBytes = qint64(64) << 20;

// NAME.dips beside the project's file NAME.dipw.
QString dipCacheFile(const QString& project);

// Puts the dips of `result` into the file beside `project`, which is replaced whole or not at all,
// and lets go of the oldest in it until it has no more than `most` bytes. Left out are dips that
// another solver took over. Nothing is written where all are there already; what is there and
// cannot be read is let go of. Any thread, one at a time a project. Throws Error where the file
// cannot be written.
void cacheDips(const JobResult& result, const QString& project, qint64 most = mostCacheBytes);

// What runJob() can take over as its `previous`: the films of all dips of `project` as they were
// kept beside the file `path`, laid on the body again, and nothing else. Null where not all of them
// are there. All cores. Throws Error where the file is damaged or is not one of kept dips,
// Cancelled.
std::shared_ptr<const JobResult> cachedDips(const Project& project, const SolverRegistry& registry,
                                            const QString& path, const Progress& progress);

} // namespace dipwright

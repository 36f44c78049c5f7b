// Caches the dips of a project in a file beside it, so that an opened project shows its results
// without dipping again.
//
// The file is a zip with one entry for each dip, the newest last, named by a hash of all that the
// dip depends on. Dips of earlier states of the project stay until there is no room for them. The
// rest of a result is computed again from the films (docs/files-and-commands.md, "Kept dips").
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// The size limit of a project's cache; older dips are removed.
inline constexpr qint64 mostCacheBytes = qint64(64) << 20;

// Returns NAME.dips beside the project's file NAME.dipw.
QString dipCacheFile(const QString& project);

// Adds the dips of `result` to the cache file beside `project` and removes the oldest until it has
// at most `most` bytes. The file is replaced by an atomic write. Dips that another solver took over
// are not cached. Nothing is written if all dips are cached already; unreadable contents are
// dropped. Any thread, but only one at a time for each project. Throws Error if the file cannot be
// written.
void cacheDips(const JobResult& result, const QString& project, qint64 most = mostCacheBytes);

// Returns a result for runJob() to take over as `previous`. It holds only the cached films of all
// dips of `project`, laid on the body again; the cache lies beside the file `path`. Null if a dip
// is missing. All cores. Throws Error if the file is damaged or no dip cache, or Cancelled.
std::shared_ptr<const JobResult> cachedDips(const Project& project, const SolverRegistry& registry,
                                            const QString& path, const Progress& progress);

} // namespace dipwright

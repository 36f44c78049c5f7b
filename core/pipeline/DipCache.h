// Caches the dips of a project in a file beside the project, so that the program can show the
// results of an opened project without simulating the dips again.
//
// The file is a zip with one entry for each dip, the newest last. An entry's name contains a hash
// of everything that the dip depends on. Dips of earlier states of the project stay until their
// room is needed. All other results are computed again from the films (docs/files-and-commands.md,
// "Cached dips").
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "pipeline/JobResult.h"

#include <functional>

namespace dipwright {

// The size limit of a project's cache; older dips are removed.
inline constexpr qint64 mostCacheBytes = qint64(64) << 20;

// Returns NAME.dips beside the project's file NAME.dipw.
QString dipCacheFile(const QString& project);

// Adds the dips of `result` to the cache file beside `project`, and removes the oldest dips until
// the file has at most `most` bytes. Replaces the file by an atomic write. Does not cache a dip
// that another solver computed because the chosen solver failed. Writes nothing if all dips are
// cached already. Drops unreadable contents. May be called from any thread, but only from one at a
// time for each project. Throws Error if the file cannot be written.
void cacheDips(const JobResult& result, const QString& project, qint64 most = mostCacheBytes);

// Returns a result that can be passed to runJob() as `previous`. It contains only the cached films
// of all dips of `project`, laid on the body again. The cache lies beside the file `path`. Returns
// null if a dip is missing. Uses all cores. Throws Error if the file is damaged or is not a dip
// cache. Throws Cancelled.
std::shared_ptr<const JobResult> cachedDips(const Project& project, const SolverRegistry& registry,
                                            const QString& path, const Progress& progress);

// Like cachedDips(), for dips that this solver simulated, here or on another computer. The solver
// need not exist here. Returns null if a dip of this solver and program version is missing.
std::shared_ptr<const JobResult> cachedDipsOf(const Project& project, const SolverInfo& solver,
                                              const QString& path, const Progress& progress);

// Like cachedDips(), but returns null if the file cannot be read, after calling `onDamage`. For
// callers that simulate the dips again in that case.
std::shared_ptr<const JobResult> usableDips(const Project& project, const SolverRegistry& registry,
                                            const QString& path, const Progress& progress,
                                            const std::function<void(const Error&)>& onDamage);

} // namespace dipwright

// Runs a project on a job server and fetches its dips.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "serving/ServerAddress.h"

namespace dipwright {

struct ServerAccess {
    ServerAddress address;
    QByteArray token;
};

// Sends the project, waits until it has run, and returns its films, laid on the body again: a
// result that can be passed to runJob() as `previous`, as cachedDips() returns it. Removes the job
// from the server, also after an error or when cancelled. Any thread. Throws Error or Cancelled.
std::shared_ptr<const JobResult> remoteDips(const Project& project, const ServerAccess& server,
                                            const Progress& progress);

} // namespace dipwright

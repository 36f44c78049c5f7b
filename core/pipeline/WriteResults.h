// A job's files.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Writes every file of docs/files-and-commands.md, "Result files", into `folder`, which is made if
// it is missing: into a temporary folder first, moved in place at the end, so that nothing
// half-written stays behind. Earlier results there are replaced, other files are left alone. Throws
// Error or Cancelled.
void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress);

// Runs the job (runJob) and writes its results (writeResults) in one: the files of one immersion
// while the next is dipped. A folder that cannot be written is found out before the job.
JobResult runAndWrite(const Project& project, const SolverRegistry& registry,
                      const JobOptions& options, const QString& folder, const Progress& progress);

// Throws Error where writeResults could not write: worth asking before a long job.
void checkResultFolder(const QString& folder);

} // namespace dipwright

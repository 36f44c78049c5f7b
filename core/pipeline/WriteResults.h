// A job's files.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

namespace dipwright {

// Writes every file of docs/files-and-commands.md, "Result files", into `folder`, which is made if
// it is missing, whole or not at all (disk/FolderTransaction.h). Earlier results there are
// replaced, other files are left alone. Throws Error or Cancelled.
void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress);

// Where the results of several projects go: for each a folder in `folder` with its file's name,
// made different from the others by a number.
QStringList resultFolders(const QStringList& projects, const QString& folder);

// Writes the cradles of the result, made if it has none, into `folder` in the same way, and nothing
// else. Returns them.
std::vector<Cradle> writeCradles(const JobResult& result, const QString& folder,
                                 const Progress& progress);

// Runs the job (runJob) and writes its results (writeResults) in one: the files of one immersion
// while the next is dipped. A folder that cannot be written is found out before the job.
JobResult runAndWrite(const Project& project, const SolverRegistry& registry,
                      const JobOptions& options, const QString& folder, const Progress& progress);

} // namespace dipwright

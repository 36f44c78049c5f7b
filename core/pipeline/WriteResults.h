// Writes a job's result files.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"
#include "project/OutputSets.h"

namespace dipwright {

// Writes all files of docs/files-and-commands.md, "Result files", into `folder`, or none
// (disk/FolderTransaction.h). Creates the folder, replaces earlier results and leaves other files
// alone. Throws Error or Cancelled.
void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress);

// Returns the results folder of each project file within `folder`. It has the name of the project
// file, and a number if that name is taken.
QStringList resultFolders(const QStringList& projects, const QString& folder);

// Writes only the cradles, all or none, and returns them. Makes the cradles if the result has none.
std::vector<Cradle> writeCradles(const JobResult& result, const QString& folder,
                                 const Progress& progress);

// Writes only the files of one output, all or none: the same bytes as writeResults(). Removes other
// files of outputFiles(output). Returns notes for the user. Throws Error if there is nothing to
// write, or for print files (app/outputs writes them).
QStringList writeOutput(const JobResult& result, Output output, const QString& folder,
                        const Progress& progress);

// Runs the job (runJob) and writes its results (writeResults). Writes the files of one dip while
// the next dip runs. `previous` is as in runJob(). Throws Error before the job if the folder cannot
// be written.
JobResult runAndWrite(const Project& project, const SolverRegistry& registry,
                      const JobOptions& options, const JobResult* previous, const QString& folder,
                      const Progress& progress);

} // namespace dipwright

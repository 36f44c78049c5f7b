// Writes files on the worker thread while the user continues working.
#pragma once

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

using WriteFile = std::function<void(const QString& path, const Progress& progress)>;

// Writes `path`, a file or folder, on the worker thread. Afterwards the user sees the sentence
// `done`, in which the path replaces %1. `title` names the job and its error message.
void writeFiles(JobRunner& jobs, Messages& messages, const QString& title, const QString& done,
                const QString& path, const WriteFile& write);

} // namespace dipwright

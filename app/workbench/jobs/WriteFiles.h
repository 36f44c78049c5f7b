// Files that are written on the worker thread while the user goes on working.
#pragma once

#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

using WriteFile = std::function<void(const QString& path, const Progress& progress)>;

// Has `path`, a file or folder, written on the worker thread. `done` is what the user is told then,
// its %1 the path; `title` is what runs, and what failed if it does.
void writeFiles(JobRunner& jobs, Messages& messages, const QString& title, const QString& done,
                const QString& path, const WriteFile& write);

} // namespace dipwright

// Prints a job's verdict in the same way for all commands that run a job.
#pragma once

#include "pipeline/JobResult.h"

#include <QTextStream>

namespace dipwright::cli {

// Prints the verdict and all reasons for it, worst first.
void printVerdict(const JobResult& result, QTextStream& out);

} // namespace dipwright::cli

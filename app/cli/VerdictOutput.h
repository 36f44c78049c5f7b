// A job's verdict, as every command that runs one tells it.
#pragma once

#include "pipeline/JobResult.h"

#include <QTextStream>

namespace dipwright::cli {

// What is to be done with the sheets, and every reason for it, the worst first.
void tellVerdict(const JobResult& result, QTextStream& out);

} // namespace dipwright::cli

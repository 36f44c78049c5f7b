// Makes a report of a job's figures for other programs.
#pragma once

#include "pipeline/JobResult.h"

#include <QJsonObject>

namespace dipwright {

// Returns the contents of report.json.
QJsonObject report(const Project& project, const JobResult& result);

} // namespace dipwright

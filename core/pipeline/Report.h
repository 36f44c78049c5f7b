// Makes report.json, from which other programs read a job's figures.
#pragma once

#include "pipeline/JobResult.h"

#include <QJsonObject>

namespace dipwright {

// Returns the contents of report.json.
QJsonObject report(const Project& project, const JobResult& result);

} // namespace dipwright

// A job's figures for other programs.
#pragma once

#include "pipeline/JobResult.h"

#include <QJsonObject>

namespace dipwright {

// What stands in report.json.
QJsonObject report(const Project& project, const JobResult& result);

} // namespace dipwright

// Describes the warnings of a job for report and view.
#pragma once

#include "pipeline/JobWarnings.h"
#include "workbench/widgets/Units.h"

#include <QColor>

namespace dipwright {

// Returns a text such as "Torn film, 12 mm², Belly"; the dip's name if there are several dips.
QString warningText(const JobWarning& warning, const JobResult& result, LengthUnit unit);
QColor warningColour(WarningKind kind);

} // namespace dipwright

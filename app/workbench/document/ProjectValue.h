// Reads and sets a project's values by their path in the schema, such as "film.swell" or
// "immersions[0].offset_mm".
#pragma once

#include "project/Field.h"

namespace dipwright {

struct Project;

// Returns the rule for the value. Throws Error for an unknown path.
FieldRule valueRule(const QString& path);
// Returns Undefined if the project has no such dip.
QJsonValue valueAt(const Project& project, const QString& path);
// Throws Error if the value breaks the rule, and leaves the project unchanged.
void setValueAt(Project& project, const QString& path, const QJsonValue& value);

} // namespace dipwright

// A project's values by their path in the schema ("film.swell", "immersions[0].offset_mm"), as the
// property panels use them.
#pragma once

#include "project/Field.h"

namespace dipwright {

struct Project;

// What the value may be. Throws Error for an unknown path.
FieldRule valueRule(const QString& path);
// Undefined for an immersion that the project has not.
QJsonValue valueAt(const Project& project, const QString& path);
// Throws Error when the value breaks the rule; the project is then as it was.
void setValueAt(Project& project, const QString& path, const QJsonValue& value);

} // namespace dipwright

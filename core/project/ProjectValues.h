// Lists the values of a project by the paths that setByPath() takes, with their rules.
#pragma once

#include "project/Field.h"

#include <vector>

namespace dipwright {

struct Project;

// A value of a project.
struct ProjectValue {
    QString path; // such as "film.swell" or "immersions[0].rotation_deg"
    FieldRule rule;
    QJsonValue value; // as in the project file
    // Whether it is a list of marks: masks, tolerance.marks or share.marks. Such a list is one
    // value, an array of objects without a rule; setByPath() takes it as JSON.
    bool isMarks = false;
};

// Returns all values that setByPath() can set, in the order of the file's schema.
std::vector<ProjectValue> projectValues(const Project& project);
// Returns one of them. Throws the same Error as setByPath() if there is no such value.
ProjectValue valueByPath(const Project& project, const QString& path);

// The order in which values must be set, because setting one changes others: lower numbers first.
// The film's preset, then its size, then all other values.
int settingOrder(const QString& path);

} // namespace dipwright

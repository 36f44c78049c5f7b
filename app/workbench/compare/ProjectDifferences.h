// In which settings two states of a project differ, in the words of its fields.
#pragma once

#include "workbench/widgets/Units.h"

#include <vector>

namespace dipwright {

struct Project;

struct ProjectDifference {
    QString setting;       // "Film · Swell"
    QString first, second; // what it is in either
};

// In the order of the project's parts; empty for equal settings. The artwork's layers stand
// at the end, by where they lie in it. What is no setting (model, photos, parts) is left out.
std::vector<ProjectDifference> projectDifferences(const Project& first, const Project& second,
                                                  LengthUnit unit);

} // namespace dipwright

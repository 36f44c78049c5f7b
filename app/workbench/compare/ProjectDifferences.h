// Lists the settings in which two states of a project differ, with the labels of the fields.
#pragma once

#include "workbench/widgets/Units.h"

#include <vector>

namespace dipwright {

struct Project;

struct ProjectDifference {
    QString setting;       // "Film · Swell"
    QString first, second; // its value in each state
};

// Returns the differences in the order of the project's pages; empty if all settings are equal. The
// artwork's layers come last, from the bottom up. Model, photos and measured parts are no settings
// and are left out.
std::vector<ProjectDifference> projectDifferences(const Project& first, const Project& second,
                                                  LengthUnit unit);

} // namespace dipwright

// Begins a project and gives it its model.
#pragma once

#include "base/Units.h"

#include <QString>

namespace dipwright {

struct ImportedModel;
struct ImportOptions;
struct Project;

// Returns a project without a model. It has the name of the file `path`, the date of today, a film
// with automatic cells, the work limit newProjectFilmWork and the wanted error
// newProjectWantedError, and one dip with steps of newProjectContactTravel.
Project newProject(const QString& path);
// Million points × steps; some 15 to 35 s on two cores. A file that does not have the field keeps
// defaultFilmWork, so the sheets of older projects stay the same.
inline constexpr double newProjectFilmWork = 128;
// With half the cell, a sheet with this numerical error is expected to move by at most half of it,
// mostHalfSpacingChange (SheetChange.h); see docs/film-validation.md, "The wanted error".
inline constexpr Millimetres newProjectWantedError{0.3};
// ProcessSettings::contactTravel. For equal work, the sheet is more exact with these steps and
// smaller cells than with the steps of older projects (docs/film-validation.md, "Balance of step
// and cell").
inline constexpr double newProjectContactTravel = 0.5;

// Gives the project an imported model, and records the file and the options that it came from.
void setModel(Project& project, const ImportedModel& imported, const QString& source,
              const ImportOptions& options);

} // namespace dipwright

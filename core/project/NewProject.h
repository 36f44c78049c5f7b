// Begins a project and gives it its model.
#pragma once

#include <QString>

namespace dipwright {

struct ImportedModel;
struct ImportOptions;
struct Project;

// Returns a project without a model. It has the name of the file `path`, the date of today, a film
// with automatic cells and the work limit newProjectFilmWork, and one dip.
Project newProject(const QString& path);
// Million points × steps; about 20 s on two cores. A file that does not have the field keeps
// defaultFilmWork, so the sheets of older projects stay the same.
inline constexpr double newProjectFilmWork = 100;

// Gives the project an imported model, and records the file and the options that it came from.
void setModel(Project& project, const ImportedModel& imported, const QString& source,
              const ImportOptions& options);

} // namespace dipwright

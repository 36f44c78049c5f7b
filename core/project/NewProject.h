// Begins a project and gives it its model.
#pragma once

#include <QString>

namespace dipwright {

struct ImportedModel;
struct ImportOptions;
struct Project;

// Returns a project without a model. It has the name of the file `path`, the date of today, a film
// with automatic cells, and one dip.
Project newProject(const QString& path);

// Gives the project an imported model, and records the file and the options that it came from.
void setModel(Project& project, const ImportedModel& imported, const QString& source,
              const ImportOptions& options);

} // namespace dipwright

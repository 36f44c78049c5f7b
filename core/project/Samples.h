// Finds the sample projects that are shipped with the program.
#pragma once

#include <QStringList>

namespace dipwright {

// Returns the paths of the sample projects, installed or built.
QStringList sampleProjects();

} // namespace dipwright

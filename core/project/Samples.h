// The projects that come with the program.
#pragma once

#include <QStringList>

namespace dipwright {

// The files of the sample projects, where they are installed or built.
QStringList sampleProjects();

} // namespace dipwright

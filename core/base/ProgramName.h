// The common name of all Dipwright programs. The folders for settings, profiles and caches depend
// on this name. Because all programs share it, the command line finds what the window has saved.
#pragma once

#include <QString>

namespace dipwright {

// Sets name and version of the running program. Call it once, after the application object is
// created and before one of these folders is used.
void nameProgram();

// Returns the version from the project's CMakeLists.txt, such as "1.0.0". All other code takes the
// version from here.
QString programVersion();

// Returns the folder where the command line kept the user's data up to version 0.1.
QString earlierDataFolder();

} // namespace dipwright

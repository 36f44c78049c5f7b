// The name of all the programs, by which the system finds the folders for their settings, profiles
// and caches. All programs share one name, so that what is saved in the window is there on the
// command line.
#pragma once

#include <QString>

namespace dipwright {

// Sets name and version of the running program. Call it once, after the application object is
// created and before any of those folders is looked up.
void nameProgram();

// Returns the version from the project's CMakeLists.txt, such as "1.0.0". All other code takes the
// version from here.
QString programVersion();

// Returns the folder for the user's data that only the command line used up to version 0.1.
QString earlierDataFolder();

} // namespace dipwright

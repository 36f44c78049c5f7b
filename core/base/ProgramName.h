// What the programs are called, by which the system finds the folders for their settings, profiles
// and caches: one for all of them, so that what is saved in the window is there on the command
// line.
#pragma once

#include <QString>

namespace dipwright {

// Name and version of the running program. Once, when the application is there, and before any of
// those folders is asked for.
void nameProgram();

// "1.0.0": the version in the project's CMakeLists.txt, which all else takes from here.
QString programVersion();

// The folder for the user's data that the command line had by itself up to version 0.1.
QString earlierDataFolder();

} // namespace dipwright

// Gives tests the folders of the build and of the repository. `below` is a path below the folder
// and begins with a slash.
#pragma once

#include <QString>

QString binaryFolder(const char* below = "");    // the programs
QString pluginFolder(const char* below = "");    // solvers that work
QString badModuleFolder(const char* below = ""); // solvers that misbehave
QString sampleFolder(const char* below = "");    // the sample projects, and models in /models
QString sourceFolder(const char* below = "");    // the repository
QString sharedFolder(const char* below = ""); // shared models beside the repository; may be missing

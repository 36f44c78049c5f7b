// Where a test finds what is built and what lies in the repository. `below` is a path from there,
// with a slash in front.
#pragma once

#include <QString>

QString binaryFolder(const char* below = "");    // the programs
QString pluginFolder(const char* below = "");    // solvers that work
QString badModuleFolder(const char* below = ""); // solvers that misbehave
QString sampleFolder(const char* below = "");    // the sample projects, and models in /models
QString sourceFolder(const char* below = "");    // the repository
QString sharedFolder(const char* below = "");    // the models beside it, which may be missing

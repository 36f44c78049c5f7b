// The folder of the running program, from which ShippedFolders.h finds everything else.
#pragma once

#include <QString>

namespace dipwright {

// Returns the folder that setProgramFolder() named; without it, the folder of the running
// executable.
QString programFolder();

// For a library that another program loads, such as the Python module: names the folder that
// contains Dipwright's programs. Call it once, before anything else of Dipwright.
void setProgramFolder(const QString& folder);

} // namespace dipwright

// The folder into which `print --plates` writes plates.
#pragma once

#include "base/Progress.h"
#include "pipeline/JobResult.h"

#include <QTextStream>
#include <vector>

namespace dipwright {
class PrinterColour;
}

namespace dipwright::cli {

// Checks before a job runs whether plates can be written: throws Error if the folder cannot be
// written, or if it has a file of one of their names that no earlier call has listed in
// plates.json. `dips` are the indices of the dips, `count` is the project's number of dips.
void checkPlatesFolder(const QString& folder, const std::vector<std::size_t>& dips,
                       std::size_t count);

// Writes the plates of the dips with these indices, and prints their figures. If the project has
// several dips, the plates of each lie in the folder immersion-N. Removes the plates of the same
// dip and of other jobs that earlier calls have listed in plates.json, and no other file. Throws
// Error as above. All files are written, or none. `colour` is that of the project's printer
// profile, in CMYK.
void writePlates(const JobResult& result, const std::vector<std::size_t>& dips,
                 const PrinterColour& colour, const QString& folder, const Progress& progress,
                 QTextStream& out);

} // namespace dipwright::cli

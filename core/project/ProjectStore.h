// Reads and writes project files *.dipw: a zip with `mimetype` (first, stored), project.json,
// assets/ and any entries of other programs (docs/files-and-commands.md, "The project file").
#pragma once

#include "base/Progress.h"
#include "disk/FileVersion.h"

#include <functional>

namespace dipwright {

struct Project;

// Reads a project and migrates older versions in memory. Throws Error if the file is missing,
// empty, truncated, encrypted or not a zip. Also throws Error if it is too large when unpacked, has
// entries with unsafe paths, or is of a newer version.
Project loadProject(const QString& path);

// Reads only the id of the project's solver, so that the solver can load while the project is read.
// Throws Error.
QString solverOfProject(const QString& path);

// Writes the project by an atomic write (disk/AtomicFile.h). Does not check whether others have
// changed the file; ProjectFile does. Returns the version of the new contents. Throws Error (not
// writable, disk full, or too large to be read again). Throws Cancelled before it replaces the
// file. `beforeReplacing`: as in replaceFile().
FileVersion saveProject(const Project& project, const QString& path,
                        const std::function<void()>& beforeReplacing = {},
                        const Progress& progress = {});

} // namespace dipwright

// Project files *.dipw: a zip with `mimetype` (first, stored), project.json, assets/ and whatever
// else others have put there (docs/files-and-commands.md, "The project file").
#pragma once

#include "disk/FileVersion.h"

#include <functional>

namespace dipwright {

struct Project;

// Reads a project, migrating older versions in memory. Throws Error: missing, empty, truncated,
// encrypted, not a zip, larger than sane when unpacked, entries with unsafe paths, a newer version.
Project loadProject(const QString& path);

// The solver that the file's project asks for, as it stands there and without anything else of it:
// for who gets it ready while the project is read. Throws Error.
QString solverOfProject(const QString& path);

// Writes the whole file or leaves the old one whole (disk/AtomicFile.h), whatever it holds now: who
// read it before and wants to know uses ProjectFile. Returns what the file now holds. Throws Error
// (not writable, disk full, more in the project than would be read again). `lastLook`: as of
// replaceFile().
FileVersion saveProject(const Project& project, const QString& path,
                        const std::function<void()>& lastLook = {});

} // namespace dipwright

// Locks a project's file while it is open, and detects changes by programs that ignore the lock.
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "disk/FileLock.h"
#include "disk/FileVersion.h"

namespace dipwright {

struct Project;

// Thrown if another program has written the file since it was read. The file is then left alone.
class ChangedFile : public Error {
public:
    using Error::Error;
};

// Writes the project (saveProject) if its file still has the version `known` or does not exist any
// more. Then sets `known` to the new version. Throws ChangedFile, Error, or Cancelled before it
// replaces the file.
void replaceProject(const Project& project, const QString& path, FileVersion& known,
                    const Progress& progress = {});

// An open project file. Holds its lock.
class ProjectFile {
public:
    // Construct it before the project is read. Throws Error if another program has the file open.
    explicit ProjectFile(const QString& path);

    // See replaceProject().
    void save(const Project& project) { replaceProject(project, path_, known_); }

private:
    QString path_;
    FileLock lock_;
    FileVersion known_;
};

} // namespace dipwright

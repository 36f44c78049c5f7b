// A project's file while somebody works on it: nobody else writes it meanwhile, and who does so
// without asking is noticed.
#pragma once

#include "base/Error.h"
#include "disk/FileLock.h"
#include "disk/FileVersion.h"

namespace dipwright {

struct Project;

// Thrown where a file is not as it was when it was read: somebody else has written it since. It is
// then left as it is.
class ChangedFile : public Error {
public:
    using Error::Error;
};

// Writes the project (saveProject) where its file still has the contents `known`, which are those
// written afterwards, or is gone. Throws ChangedFile or Error.
void replaceProject(const Project& project, const QString& path, FileVersion& known);

class ProjectFile {
public:
    // Before the project is read. Throws Error where another program has the file open.
    explicit ProjectFile(const QString& path);

    // As replaceProject.
    void save(const Project& project) { replaceProject(project, path_, known_); }

private:
    QString path_;
    FileLock lock_;
    FileVersion known_;
};

} // namespace dipwright

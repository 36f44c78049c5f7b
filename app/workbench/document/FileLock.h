// A lock beside an open project, so that two people do not overwrite each other's work. A lock left
// behind by a crash on this machine is recognised and taken over.
#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace dipwright {

struct LockState {
    bool acquired = true;
    // Who holds it, where it was not acquired; empty where that cannot be read.
    QString host = {}, program = {};
    qint64 process = 0;
};

class FileLock {
public:
    // Lets go of what was held before. An empty path locks nothing; so does a folder that cannot be
    // written, in which the project cannot be overwritten either.
    LockState acquire(const QString& path);
    // Removes another's lock first: only when the user has said so.
    void acquireByForce(const QString& path);

private:
    std::unique_ptr<QLockFile> lock_;
};

} // namespace dipwright

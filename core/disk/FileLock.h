// A lock file beside a file that a program works on, so that two programs do not overwrite each
// other's work. It is advisory: a program that does not ask for it is not stopped.
#pragma once

#include "disk/LockedFile.h"
#include "disk/UnfinishedWrites.h"

#include <QString>
#include <memory>

namespace dipwright {

struct LockState {
    bool acquired = true;
    // The holder, if the lock was not acquired; empty if it cannot be read.
    QString host = {}, program = {};
    qint64 process = 0;
};

// Holds the lock while the object lives. The system releases it when the process ends.
class FileLock {
public:
    FileLock() = default;
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    // Releases the lock held before, then takes the lock of `path`. Locks nothing if `path` is
    // empty or its folder cannot be written. In a folder that cannot be written, nobody can replace
    // the file either.
    LockState acquire(const QString& path);
    void release();
    bool isHeld() const { return file_ != nullptr; }

private:
    std::unique_ptr<UnfinishedWrite> note_;
    std::unique_ptr<LockedFile> file_;
};

// Returns "dipwright on HOST, process N", for a message about who holds a lock.
QString holderText(const LockState& holder);

} // namespace dipwright

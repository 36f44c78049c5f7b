// A lock beside a file that somebody works on, so that two do not overwrite each other's work. It
// is advice: who does not ask for it is not stopped.
#pragma once

#include "disk/LockedFile.h"
#include "disk/UnfinishedWrites.h"

#include <QString>
#include <memory>

namespace dipwright {

struct LockState {
    bool acquired = true;
    // Who holds it, where it was not acquired; empty where that cannot be read.
    QString host = {}, program = {};
    qint64 process = 0;
};

// Held as long as the object lives, and no longer than its process does.
class FileLock {
public:
    FileLock() = default;
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    // Lets go of what was held before. An empty path locks nothing; so does a folder that cannot be
    // written, in which the file cannot be replaced either.
    LockState acquire(const QString& path);
    void release();
    bool isHeld() const { return file_ != nullptr; }

private:
    std::unique_ptr<UnfinishedWrite> note_;
    std::unique_ptr<LockedFile> file_;
};

// "dipwright on HOST, process N", for a sentence on who holds a lock.
QString holderText(const LockState& holder);

} // namespace dipwright

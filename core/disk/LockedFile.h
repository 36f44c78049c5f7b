// A file that only one process at a time has open for writing, and other file operations that
// differ between systems.
#pragma once

#include <QFile>
#include <QString>

namespace dipwright {

// The operating system releases the lock when the process ends, so no lock is ever outdated. On a
// file system without locks, open() returns Opened although nothing is locked.
class LockedFile {
public:
    enum class Outcome {
        Opened,        // opened and locked; contents from an earlier process are still in the file
        HeldByAnother, // locked by a running process, perhaps by this one
        Failed,        // errorString() says why
    };

    LockedFile() = default;
    ~LockedFile() = default; // closes and unlocks; the file stays
    // Opens the file and creates it if it is missing. Refuses links, files with several hard links,
    // and everything that is not a regular file, because such files belong to somebody else.
    Outcome open(const QString& path);
    bool isOpen() const { return file_.isOpen(); }
    // Whether the system really locked the file; false on a file system without locks. Only a real
    // lock proves that no other process is doing the work that the file records.
    bool isLocked() const { return isLocked_; }
    QFile& device() { return file_; }
    QString errorString() const;

    // Removes the file while it is still locked, then unlocks it. Returns false if the file is
    // still there.
    bool remove();
    // Renames the file over `target`, which is replaced atomically, and unlocks it. If it returns
    // false, the file is closed and nothing else has changed.
    bool moveOver(const QString& target);

private:
    QString path_;
    QString failure_;
    QFile file_;
    bool isLocked_ = false;
};

// Flushes the file to disk. When it returns true, the contents are on the disk itself.
bool syncToDisk(QFile& file);
// Flushes a folder's list of names to disk. Does nothing if the file system cannot do that.
void syncFolder(const QString& path);
// Renames a file or folder. A file at `to` is replaced atomically.
bool moveOver(const QString& from, const QString& to);

} // namespace dipwright

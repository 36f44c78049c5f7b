// A file that only one process at a time has open for writing, and other file operations that
// differ between systems.
#pragma once

#include <QFile>
#include <QString>

namespace dipwright {

// The lock belongs to the operating system: it ends with the process, so its age never has to be
// judged. On a file system without locks every file counts as locked.
class LockedFile {
public:
    enum class Outcome {
        Opened,        // and locked; contents that another process left are still in it
        HeldByAnother, // by a living process, this one or another
        Failed,        // errorString() says why
    };

    LockedFile() = default;
    ~LockedFile() = default; // closes and unlocks; the file stays
    // Opens the file and creates it if it is missing. Refuses a link, anything but a plain file,
    // and a file with a second name, because they belong to somebody else.
    Outcome open(const QString& path);
    bool isOpen() const { return file_.isOpen(); }
    // Whether the system really locked the file; false on a file system without locks. Only then is
    // it certain that no process owns what the file stands for.
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
// Flushes the names in a folder to disk, if the file system can do that; it is no failure if it
// cannot.
void syncFolder(const QString& path);
// Renames a file or folder. A file at `to` is replaced atomically.
bool moveOver(const QString& from, const QString& to);

} // namespace dipwright

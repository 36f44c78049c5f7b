// A file that one process at a time has open for writing, and what the system alone can do with
// files: the small part that differs between systems.
#pragma once

#include <QFile>
#include <QString>

namespace dipwright {

// The lock is the system's: it goes with the process, however that ends, and never has to be judged
// by age. Where a file system has no locks, every file counts as locked.
class LockedFile {
public:
    enum class Outcome {
        Opened,        // and locked: with what another has left in it
        HeldByAnother, // alive, in this process or another
        Failed,        // errorString() says why
    };

    LockedFile() = default;
    ~LockedFile() = default; // closed, and let go of; the file stays
    // Opens the file, which is made where it is missing. Refused where a link, anything but a plain
    // file, or one that has a second name lies there: it is another's.
    Outcome open(const QString& path);
    bool isOpen() const { return file_.isOpen(); }
    // Whether the system has locked it: false, too, where it has no locks. Only then is what a file
    // stands for known to be nobody's.
    bool isLocked() const { return isLocked_; }
    QFile& device() { return file_; }
    QString errorString() const;

    // While nobody else can have it, then lets go of it. False: it is still there.
    bool remove();
    // Renames it over `target`, which is replaced in one go, and lets go of it. False: nothing has
    // changed but that the file is closed.
    bool moveOver(const QString& target);

private:
    QString path_;
    QString failure_;
    QFile file_;
    bool isLocked_ = false;
};

// What was written to the file is on the disk itself when this returns true.
bool syncToDisk(QFile& file);
// The same of the names in a folder, as well as the system can: a file system that cannot is no
// failure.
void syncFolder(const QString& path);
// Renames a file or folder; a file at `to` is replaced in one go.
bool moveOver(const QString& from, const QString& to);

} // namespace dipwright

// Files that are replaced whole or not at all, whatever dies meanwhile.
//
// The new contents are written to a file beside the old one, flushed to the disk and renamed over
// it; then the folder is flushed. The file beside it has one name for each target and is locked
// while it is written, so that two writers of one file cannot mix, and what a dead one has left is
// known for what it is.
#pragma once

#include "disk/LockedFile.h"
#include "disk/UnfinishedWrites.h"

#include <QString>
#include <functional>
#include <memory>

namespace dipwright {

class AtomicFile {
public:
    // A link is followed: what it points to is replaced.
    explicit AtomicFile(const QString& path);
    ~AtomicFile(); // without a commit: the target is as it was, and nothing stays behind

    // Both: empty when done, else why not in the system's words.
    QString open();
    QString commit();
    QFile& device() { return file_.device(); } // between the two, to write to

private:
    QString target_, beside_;
    std::unique_ptr<UnfinishedWrite> note_;
    LockedFile file_;
};

// Replaces a file. Empty when done, else why not in the system's words. `lastLook` is called when
// all is written and nobody else can replace the file any more, and may end it by throwing.
QString replaceFile(const QString& path, const QByteArray& bytes,
                    const std::function<void()>& lastLook = {});
// The same with what `write` puts into the device it is given. Throws Error.
void writeAtomically(const QString& path, const std::function<void(QIODevice&)>& write);
// Throws Error where the file could not be replaced now: worth asking before long work.
void checkWritable(const QString& path);

// What lies hidden beside a file while somebody is at it.
enum class Beside { NewContents, Lock };
// Its name, the same whenever it is asked for, that no file name is too long for: a beginning of
// its own and the file's name, or a hash of that.
QString hiddenBeside(const QString& path, Beside what);
// Whether a file's name begins so.
bool isHiddenBeside(const QString& path);
// Removes a temporary file, unless somebody is writing it.
void removeAbandoned(const QString& temporary);

} // namespace dipwright

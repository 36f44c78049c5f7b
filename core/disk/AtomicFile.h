// Atomic writes: a file is replaced completely or not at all, even if the program or the computer
// crashes.
//
// The new contents are written to a temporary file beside the old one, flushed to disk and renamed
// over it. Then the folder is flushed. Each target has one fixed name for its temporary file, which
// is locked while it is written. So two writers of one file cannot mix their contents, and a file
// that a crashed writer left behind is recognised.
#pragma once

#include "disk/LockedFile.h"
#include "disk/UnfinishedWrites.h"

#include <QString>
#include <functional>
#include <memory>

namespace dipwright {

class AtomicFile {
public:
    // Follows a link: the file that it points to is replaced.
    explicit AtomicFile(const QString& path);
    ~AtomicFile(); // without a commit the target is unchanged and the temporary file is removed

    // Both return an empty string on success, else the system's error message.
    QString open();
    QString commit();
    QFile& device() { return file_.device(); } // for writing between open() and commit()

private:
    QString target_, beside_;
    std::unique_ptr<UnfinishedWrite> note_;
    LockedFile file_;
};

// Replaces a file. Returns an empty string on success, else the system's error message. `lastLook`
// is called when everything is written and nobody else can replace the file any more. It may throw
// to abandon the write.
QString replaceFile(const QString& path, const QByteArray& bytes,
                    const std::function<void()>& lastLook = {});
// Replaces a file by what `write` writes to its device. Throws Error.
void writeAtomically(const QString& path, const std::function<void(QIODevice&)>& write);
// Throws Error if the file cannot be replaced now. Call it before long work.
void checkWritable(const QString& path);

// The hidden files beside a file while a program works on it.
enum class Beside { NewContents, Lock };
// Returns the path of such a hidden file, always the same for one file. Its name is a fixed prefix
// and the file's name, or a hash of that name where it would be too long.
QString hiddenFilePath(const QString& path, Beside what);
// Whether the file's name has such a prefix.
bool isHiddenFile(const QString& path);
// Removes a temporary file unless somebody is writing it.
void removeAbandoned(const QString& temporary);

} // namespace dipwright

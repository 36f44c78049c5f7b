// Atomic writes: a file is replaced completely or not at all, even if the program or the computer
// crashes.
//
// The new contents are written to a temporary file beside the old one, flushed to disk and renamed
// over it. Then the folder is flushed. The temporary file of a target always has the same name, and
// is locked while it is written. Therefore two writers of one target cannot mix their contents, and
// the temporary file of a crashed writer is recognised.
#pragma once

#include "disk/LockedFile.h"
#include "disk/UnfinishedWrites.h"

#include <QString>
#include <functional>
#include <memory>

namespace dipwright {

class AtomicFile {
public:
    // If `path` is a link, the file that the link points to is replaced.
    explicit AtomicFile(const QString& path);
    // Without commit(), leaves the target unchanged and removes the temporary file.
    ~AtomicFile();

    // Creates and locks the temporary file. Returns an empty string on success, else the reason,
    // worded as part of a sentence.
    QString open();
    // Replaces the target. Returns an empty string on success, else the reason.
    QString commit();
    QFile& device() { return file_.device(); } // for writing between open() and commit()

private:
    QString target_, beside_;
    std::unique_ptr<UnfinishedWrite> note_;
    LockedFile file_;
};

// Replaces a file. Returns an empty string on success, else the reason, worded as part of a
// sentence. `beforeReplacing` is called after everything is written, while no other writer can
// replace the file. If it throws, the file is not replaced.
QString replaceFile(const QString& path, const QByteArray& bytes,
                    const std::function<void()>& beforeReplacing = {});
// Replaces a file by what `write` writes to its device. Throws Error.
void writeAtomically(const QString& path, const std::function<void(QIODevice&)>& write);
// Throws Error if the file cannot be replaced now. Call it before long work.
void checkWritable(const QString& path);

// The kinds of hidden files that lie beside a file while a program works on it.
enum class Beside { NewContents, Lock };
// Returns the path of the hidden file of kind `what` beside `path`. Equal arguments always give the
// same path. The hidden file's name is a fixed prefix and the file's name. If that is too long, a
// hash replaces the file's name.
QString hiddenFilePath(const QString& path, Beside what);
// Whether the file's name begins with the prefix of a hidden file.
bool isHiddenFile(const QString& path);
// Removes a temporary file unless a process is writing it.
void removeAbandoned(const QString& temporary);

} // namespace dipwright

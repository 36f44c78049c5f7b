// Notes of what is being written, from which the next start of the program puts right what one that
// was killed has left behind.
#pragma once

#include "base/Progress.h"
#include "disk/LockedFile.h"

#include <QStringList>

namespace dipwright {

// While an object lives, a note in the user's folder for program data says that this process is
// writing; when the process dies, the note stays. Nothing is noted where that folder cannot be
// written: then the next writer of the same file or folder puts right what it finds.
class UnfinishedWrite {
public:
    // `work`: the temporary file, or the folder of results that is written. `made`: folders that
    // were made for it, the innermost last, which go if nothing comes into them.
    explicit UnfinishedWrite(const QString& work, const QStringList& made = {});
    ~UnfinishedWrite();
    UnfinishedWrite(const UnfinishedWrite&) = delete;
    UnfinishedWrite& operator=(const UnfinishedWrite&) = delete;

    // Lets go of it as a dying process does: something is left for the next start.
    void leave();

private:
    LockedFile note_;
};

// Before a program's work: removes the temporary files of processes that have died, and brings
// their folders of results to an end (FolderTransaction). What lives is left alone. Never fails,
// takes two seconds at most where the disk answers, and ends when it is cancelled: what is left
// then is put right by the next start, or by whoever writes there next.
void recoverUnfinishedWrites(const CancelToken& cancelToken = {});

} // namespace dipwright

// Notes about files that are being written. From these notes, the next start of the program cleans
// up after a killed process.
#pragma once

#include "base/Progress.h"
#include "disk/LockedFile.h"

#include <QStringList>

namespace dipwright {

// While an object lives, a note in the user's folder for program data says that this process is
// writing. If the process dies, the note stays. If that folder cannot be written there is no note;
// then the next writer of the same file or folder cleans up.
class UnfinishedWrite {
public:
    // `work` is the temporary file, or the folder of results that is being written. `made` are
    // folders that were created to contain `work`, the innermost last; they are removed if they
    // stay empty.
    explicit UnfinishedWrite(const QString& work, const QStringList& made = {});
    ~UnfinishedWrite();
    UnfinishedWrite(const UnfinishedWrite&) = delete;
    UnfinishedWrite& operator=(const UnfinishedWrite&) = delete;

    // Unlocks the note without removing it, as if the process had died. The next start then cleans
    // up.
    void leave();

private:
    LockedFile note_;
};

// Call before the program's own work. Removes the temporary files of dead processes and completes
// their folders of results (FolderTransaction). Leaves the files of running processes alone. Never
// fails. Takes at most two seconds if the disk responds, and can be cancelled; the next start or
// the next writer does the rest.
void recoverUnfinishedWrites(const CancelToken& cancelToken = {});

} // namespace dipwright

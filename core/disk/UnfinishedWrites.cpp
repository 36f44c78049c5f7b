#include "disk/UnfinishedWrites.h"

#include "base/Bytes.h"
#include "disk/AtomicFile.h"
#include "disk/FolderTransaction.h"
#include "disk/UnfinishedNote.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QUuid>

namespace dipwright {
namespace {

constexpr qint64 longestNote = 1 << 20;  // bytes
constexpr qint64 longestRecovery = 2000; // milliseconds, at the start of a program

QDir noteFolder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
            QStringLiteral("/unfinished")};
}

// A note is a file that records an unfinished write. Completes or removes the write that `note`
// records. Returns false if work remains.
bool completeTransaction(const UnfinishedNote& note, const std::function<bool()>& shouldContinue) {
    bool done = true;
    if (isHiddenFile(note.work)) {
        removeAbandoned(note.work);
        done = !QFileInfo::exists(note.work);
    } else {
        done = FolderTransaction::completeTransaction(QFileInfo(note.work).path(), shouldContinue);
    }
    for (auto folder = note.made.rbegin(); folder != note.made.rend(); ++folder) {
        QDir().rmdir(*folder); // fails unless it is empty
    }
    return done;
}

// Cleans up after a dead process, then removes its note.
void settle(const QString& path, const std::function<bool()>& shouldContinue) {
    LockedFile file;
    if (file.open(path) != LockedFile::Outcome::Opened || !file.isLocked()) {
        return;
    }
    const auto note = noteOf(file.device().read(longestNote));
    if (!note || completeTransaction(*note, shouldContinue)) {
        file.remove();
    }
}

} // namespace

UnfinishedWrite::UnfinishedWrite(const QString& work, const QStringList& made) {
    const QDir folder = noteFolder();
    folder.mkpath(QStringLiteral("."));
    const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
    if (note_.open(folder.filePath(name)) == LockedFile::Outcome::Opened) {
        writeAll(note_.device(), bytesOf(UnfinishedNote{work, made}));
    }
}

UnfinishedWrite::~UnfinishedWrite() {
    note_.remove();
}

void UnfinishedWrite::leave() {
    note_.device().close();
}

void recoverUnfinishedWrites(const CancelToken& cancelToken) {
    QElapsedTimer clock;
    clock.start();
    const auto shouldContinue = [&] {
        return !cancelToken.isCancelled() && !clock.hasExpired(longestRecovery);
    };
    QDirIterator notes(noteFolder().path(), QDir::Files);
    while (notes.hasNext() && shouldContinue()) {
        settle(notes.next(), shouldContinue);
    }
}

} // namespace dipwright

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

// Returns false if something is left to do.
bool putRight(const UnfinishedNote& note, const std::function<bool()>& mayGoOn) {
    bool done = true;
    if (isHiddenFile(note.work)) {
        removeAbandoned(note.work);
        done = !QFileInfo::exists(note.work);
    } else {
        done = FolderTransaction::putRight(QFileInfo(note.work).path(), mayGoOn);
    }
    for (auto folder = note.made.rbegin(); folder != note.made.rend(); ++folder) {
        QDir().rmdir(*folder); // fails unless it is empty
    }
    return done;
}

// Cleans up after a dead process, then removes its note.
void settle(const QString& path, const std::function<bool()>& mayGoOn) {
    LockedFile file;
    if (file.open(path) != LockedFile::Outcome::Opened || !file.isLocked()) {
        return;
    }
    const auto note = noteOf(file.device().read(longestNote));
    if (!note || putRight(*note, mayGoOn)) {
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
    const auto mayGoOn = [&] {
        return !cancelToken.isCancelled() && !clock.hasExpired(longestRecovery);
    };
    QDirIterator notes(noteFolder().path(), QDir::Files);
    while (notes.hasNext() && mayGoOn()) {
        settle(notes.next(), mayGoOn);
    }
}

} // namespace dipwright

#include "document/FileLock.h"

#include <QFile>
#include <QFileInfo>

namespace dipwright {

namespace {

QString lockPath(const QString& path) {
    const QFileInfo file(path);
    return file.absolutePath() + QStringLiteral("/.~lock.") + file.fileName();
}

} // namespace

LockState FileLock::acquire(const QString& path) {
    lock_.reset();
    if (path.isEmpty()) {
        return {};
    }
    auto lock = std::make_unique<QLockFile>(lockPath(path));
    lock->setStaleLockTime(0); // never by age: a project may stay open for days
    if (lock->tryLock(0)) {
        lock_ = std::move(lock);
        return {};
    }
    if (lock->error() != QLockFile::LockFailedError) {
        return {};
    }
    LockState state{.acquired = false};
    lock->getLockInfo(&state.process, &state.host, &state.program);
    return state;
}

void FileLock::acquireByForce(const QString& path) {
    if (!acquire(path).acquired) {
        QFile::remove(lockPath(path));
        acquire(path);
    }
}

} // namespace dipwright

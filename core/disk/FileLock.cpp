#include "disk/FileLock.h"

#include "base/Bytes.h"
#include "disk/AtomicFile.h"
#include "disk/PlainFile.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSysInfo>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FileLock)
};

constexpr qint64 longestLock = 1024; // bytes

// All links to one file share one lock.
QString lockPath(const QString& path) {
    const QString canonical = QFileInfo(path).canonicalFilePath();
    return hiddenFilePath(canonical.isEmpty() ? path : canonical, Beside::Lock);
}

// Returns the three lines of the lock file: process, program, machine.
QByteArray ownLines() {
    return QStringLiteral("%1\n%2\n%3\n")
        .arg(QCoreApplication::applicationPid())
        .arg(QCoreApplication::applicationName(), QSysInfo::machineHostName())
        .toUtf8();
}

LockState holderOf(const QString& lock) {
    LockState state{.acquired = false};
    QFile file(lock);
    if (openToRead(file).isEmpty()) {
        const QStringList lines =
            QString::fromUtf8(file.read(longestLock)).split(QLatin1Char('\n'));
        state.process = lines.value(0).toLongLong();
        state.program = lines.value(1).left(100);
        state.host = lines.value(2).left(100);
    }
    return state;
}

} // namespace

FileLock::~FileLock() {
    release();
}

void FileLock::release() {
    if (file_ && !file_->remove()) {
        note_->leave();
    }
    file_.reset();
    note_.reset();
}

LockState FileLock::acquire(const QString& path) {
    release();
    if (path.isEmpty()) {
        return {};
    }
    note_ = std::make_unique<UnfinishedWrite>(lockPath(path));
    auto file = std::make_unique<LockedFile>();
    switch (file->open(lockPath(path))) {
    case LockedFile::Outcome::HeldByAnother:
        note_.reset();
        return holderOf(lockPath(path));
    case LockedFile::Outcome::Failed:
        note_.reset();
        return {};
    case LockedFile::Outcome::Opened:
        break;
    }
    file->device().resize(0); // removes what a crashed holder left
    writeAll(file->device(), ownLines());
    file_ = std::move(file);
    return {};
}

QString holderText(const LockState& holder) {
    return Text::tr("%1 on %2, process %3")
        .arg(holder.program.isEmpty() ? Text::tr("another program") : holder.program,
             holder.host.isEmpty() ? Text::tr("an unknown machine") : holder.host)
        .arg(holder.process);
}

} // namespace dipwright

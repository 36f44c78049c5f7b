#include "serving/StateFolders.h"

#include "base/Error.h"
#include "disk/AtomicFile.h"

#include <QDir>
#include <QFileInfo>

namespace dipwright {

StateFolders::StateFolders(const QString& path, const QStringList& states, const QString& lock)
    : path_(QDir(path).absolutePath()) {
    QDir().mkpath(path_);
    const LockState held = lock_.acquire(folder(lock));
    if (!held.acquired) {
        throw Error(QStringLiteral("The folder is already used by %1; end that program or choose "
                                   "another folder")
                        .arg(holderText(held)),
                    path_);
    }
    for (const QString& state : states) {
        if (!QDir().mkpath(folder(state))) {
            throw Error(QStringLiteral("The folder cannot be created; choose a folder that can be "
                                       "written"),
                        folder(state));
        }
    }
}

QString StateFolders::move(const QString& job, const QString& state) const {
    const QFileInfo file(job);
    for (int number = 1;; ++number) {
        const QString suffix = number > 1 ? QStringLiteral("-%1").arg(number) : QString();
        const QString target =
            QStringLiteral("%1/%2%3.%4")
                .arg(folder(state), file.completeBaseName(), suffix, file.suffix());
        if (QFileInfo::exists(target)) {
            continue;
        }
        QFile source(job);
        if (source.rename(target)) {
            return target;
        }
        if (!QFileInfo::exists(target)) {
            throw Error(QStringLiteral("The job cannot be moved to %1: %2")
                            .arg(folder(state), source.errorString()),
                        job);
        }
    }
}

QString StateFolders::end(const QString& job, const QString& state, const QString& reason) const {
    const QString file = move(job, state);
    const QString failure = replaceFile(file + QStringLiteral(".txt"), reason.toUtf8() + '\n');
    return failure.isEmpty()
               ? QString()
               : QStringLiteral(" The text file beside the job cannot be written: %1").arg(failure);
}

} // namespace dipwright

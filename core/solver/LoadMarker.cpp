#include "solver/LoadMarker.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QStandardPaths>

namespace dipwright {

namespace {

QDir markerFolder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
            QStringLiteral("/solver-loading")};
}

// Names this very file: a module that was repaired or replaced gets another name.
QString moduleKey(const QString& modulePath) {
    const QFileInfo file(modulePath);
    const QString identity = QStringLiteral("%1|%2|%3")
                                 .arg(file.absoluteFilePath())
                                 .arg(file.size())
                                 .arg(file.lastModified().toMSecsSinceEpoch());
    const QByteArray hash =
        QCryptographicHash::hash(identity.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QString::fromLatin1(hash);
}

QString crashedPath(const QString& modulePath) {
    return markerFolder().filePath(moduleKey(modulePath) + QStringLiteral(".crashed"));
}

QStringList loadingPaths(const QString& modulePath) {
    const QDir folder = markerFolder();
    QStringList paths;
    for (const QString& name :
         folder.entryList({moduleKey(modulePath) + QStringLiteral(".*.loading")}, QDir::Files)) {
        paths << folder.filePath(name);
    }
    return paths;
}

QString newLoadingPath(const QString& modulePath) {
    const QDir folder = markerFolder();
    folder.mkpath(QStringLiteral("."));
    return folder.filePath(QStringLiteral("%1.%2.loading")
                               .arg(moduleKey(modulePath))
                               .arg(QCoreApplication::applicationPid()));
}

bool isOwnerDead(const QString& loadingPath) {
    QLockFile probe(loadingPath);
    probe.setStaleLockTime(0);
    return probe.tryLock(0); // takes the lock of a dead process over, and removes it again
}

} // namespace

LoadMarker::LoadMarker(const QString& modulePath) : lock_(newLoadingPath(modulePath)) {
    lock_.setStaleLockTime(0); // no age makes it stale, only the death of its process
    lock_.tryLock(0);
}

bool LoadMarker::crashedBefore(const QString& modulePath) {
    const QString record = crashedPath(modulePath);
    for (const QString& path : loadingPaths(modulePath)) {
        if (isOwnerDead(path)) {
            QFile file(record);
            file.open(QIODevice::WriteOnly);
        }
    }
    return QFile::exists(record);
}

void LoadMarker::forget(const QString& modulePath) {
    QFile::remove(crashedPath(modulePath));
    for (const QString& path : loadingPaths(modulePath)) {
        isOwnerDead(path);
    }
}

} // namespace dipwright

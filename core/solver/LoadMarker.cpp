#include "solver/LoadMarker.h"

#include "solver/CrashSignals.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace dipwright {
namespace {

QDir markerFolder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
            QStringLiteral("/solver-loading")};
}

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

// The file has one byte for each crash.
QString crashesPath(const QString& modulePath) {
    return markerFolder().filePath(moduleKey(modulePath) + QStringLiteral(".crashes"));
}

// Marker files of this process and of dead processes.
QStringList loadingPaths(const QString& modulePath) {
    const QDir folder = markerFolder();
    QStringList paths;
    for (const QString& name :
         folder.entryList({moduleKey(modulePath) + QStringLiteral(".*.loading")}, QDir::Files)) {
        paths << folder.filePath(name);
    }
    return paths;
}

// Removes the markers of dead processes and returns how many of them crashed.
int takeCrashed(const QString& modulePath) {
    int crashed = 0;
    for (const QString& path : loadingPaths(modulePath)) {
        LockedFile marker;
        if (marker.open(path) == LockedFile::Outcome::Opened) {
            crashed += marker.device().size() > 0 ? 1 : 0;
            marker.remove();
        }
    }
    return crashed;
}

} // namespace

int crashesOf(const QString& modulePath) {
    for (int crashed = takeCrashed(modulePath); crashed > 0; --crashed) {
        rememberCrash(modulePath);
    }
    return int(QFileInfo(crashesPath(modulePath)).size());
}

void rememberCrash(const QString& modulePath) {
    markerFolder().mkpath(QStringLiteral("."));
    QFile file(crashesPath(modulePath));
    if ((!file.exists() || QFileInfo(file).isFile()) && file.open(QIODevice::Append)) {
        file.write("x");
    }
}

void forgetCrashes(const QString& modulePath) {
    takeCrashed(modulePath);
    QFile::remove(crashesPath(modulePath));
}

LoadMarker::LoadMarker(const QString& modulePath) {
    const QDir folder = markerFolder();
    folder.mkpath(QStringLiteral("."));
    const QString path = folder.filePath(QStringLiteral("%1.%2.loading")
                                             .arg(moduleKey(modulePath))
                                             .arg(QCoreApplication::applicationPid()));
    if (file_.open(path) == LockedFile::Outcome::Opened) {
        reportCrashesTo(file_.device().handle());
    }
}

LoadMarker::~LoadMarker() {
    reportCrashesTo(-1);
    file_.remove();
}

} // namespace dipwright

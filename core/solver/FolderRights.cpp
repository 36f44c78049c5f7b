#include "solver/FolderRights.h"

#include <QFile>
#include <QFileInfo>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace dipwright {

#ifdef _WIN32

QString writableByOthers(const QString&) {
    return {};
}

#else

namespace {

bool isOthers(const QString& path) {
    struct stat file {};
    if (stat(QFile::encodeName(path).constData(), &file) != 0) {
        return true;
    }
    const bool isOwn = file.st_uid == geteuid() || file.st_uid == 0;
    const bool isOwnGroup = file.st_gid == getegid() || file.st_gid == 0;
    const bool isSticky = S_ISDIR(file.st_mode) && (file.st_mode & S_ISVTX) != 0;
    const bool isWritable =
        (file.st_mode & S_IWOTH) != 0 || ((file.st_mode & S_IWGRP) != 0 && !isOwnGroup);
    return !isOwn || (isWritable && !isSticky);
}

} // namespace

QString writableByOthers(const QString& path) {
    for (QString place = QFileInfo(path).canonicalFilePath();;) {
        if (place.isEmpty() || isOthers(place)) {
            return place.isEmpty() ? path : place;
        }
        const QString parent = QFileInfo(place).path();
        if (parent == place) {
            return {};
        }
        place = parent;
    }
}

#endif

} // namespace dipwright

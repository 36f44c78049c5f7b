#include "solver/FilePermissions.h"

#include <QFile>
#include <QFileInfo>

#ifndef _WIN32
#include <cstring>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>
#endif

namespace dipwright {

#ifdef _WIN32

QString writableByOthers(const QString&) {
    return {};
}

#else

namespace {

constexpr std::size_t longestEntry = 1 << 16; // bytes of a user or group entry, members included

bool hasOthers(const group& entry, const char* user) {
    for (char** member = entry.gr_mem; *member != nullptr; ++member) {
        if (std::strcmp(*member, user) != 0) {
            return true;
        }
    }
    return false;
}

// Whether the group is private to this user: the primary group, with the user's name and no other
// members. On many systems all users share one primary group, which is not private. Neither is a
// group that cannot be looked up.
bool isPrivateGroup(gid_t groupId, uid_t userId) {
    std::vector<char> userText(longestEntry), groupText(longestEntry);
    passwd owner{}, *foundOwner = nullptr;
    group entry{}, *foundGroup = nullptr;
    if (getpwuid_r(userId, &owner, userText.data(), userText.size(), &foundOwner) != 0 ||
        getgrgid_r(groupId, &entry, groupText.data(), groupText.size(), &foundGroup) != 0 ||
        foundOwner == nullptr || foundGroup == nullptr) {
        return false;
    }
    return owner.pw_gid == groupId && std::strcmp(owner.pw_name, entry.gr_name) == 0 &&
           !hasOthers(entry, owner.pw_name);
}

bool isOthers(const QString& path) {
    struct stat file {};
    if (stat(QFile::encodeName(path).constData(), &file) != 0) {
        return true;
    }
    const bool isOwn = file.st_uid == geteuid() || file.st_uid == 0;
    const bool isSticky = S_ISDIR(file.st_mode) && (file.st_mode & S_ISVTX) != 0;
    const bool isGroupWritable = (file.st_mode & S_IWGRP) != 0 &&
                                 !isPrivateGroup(file.st_gid, geteuid()) &&
                                 !isPrivateGroup(file.st_gid, 0);
    const bool isWritable = (file.st_mode & S_IWOTH) != 0 || isGroupWritable;
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

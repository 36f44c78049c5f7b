#include "disk/LockedFile.h"

#include <QFileInfo>
#include <filesystem>
#include <system_error>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#else
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace dipwright {
namespace {

struct Handle {
    int number = -1;
    LockedFile::Outcome outcome = LockedFile::Outcome::Failed;
    bool isLocked = false;
};

#ifdef _WIN32

// Other processes may read and delete the file, but not write to it.
Handle lockedHandle(const QString& path) {
    const HANDLE handle = CreateFileW(
        QFileInfo(path).filesystemAbsoluteFilePath().c_str(), GENERIC_READ | GENERIC_WRITE | DELETE,
        FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (handle == INVALID_HANDLE_VALUE) {
        return {-1, GetLastError() == ERROR_SHARING_VIOLATION ? LockedFile::Outcome::HeldByAnother
                                                              : LockedFile::Outcome::Failed};
    }
    return {_open_osfhandle(reinterpret_cast<intptr_t>(handle), _O_RDWR | _O_BINARY),
            LockedFile::Outcome::Opened, true};
}

#else

// Whether the open file still has this name. Between opening and locking, the process that owned
// the file may have renamed or removed it.
bool isStillAt(const QByteArray& path, int handle) {
    struct stat opened {};
    struct stat named {};
    return fstat(handle, &opened) == 0 && lstat(path.constData(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

bool isPlainFile(int handle) {
    struct stat opened {};
    return fstat(handle, &opened) == 0 && S_ISREG(opened.st_mode) && opened.st_nlink <= 1;
}

// Checks another user's file, which this user can perhaps only read. Reading is enough to find out
// whether it is locked. Removes the file if it is abandoned and may be removed.
enum class OthersFile { Held, Removed, Stays };
OthersFile othersFile(const QByteArray& name) {
    const int handle = open(name.constData(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (handle < 0) {
        return OthersFile::Stays;
    }
    OthersFile outcome = OthersFile::Stays;
    if (isPlainFile(handle)) {
        if (flock(handle, LOCK_EX | LOCK_NB) == 0) {
            const bool isRemoved = isStillAt(name, handle) && unlink(name.constData()) == 0;
            outcome = isRemoved ? OthersFile::Removed : OthersFile::Stays;
        } else if (errno == EWOULDBLOCK) {
            outcome = OthersFile::Held;
        }
    }
    close(handle);
    return outcome;
}

Handle lockedHandle(const QString& path) {
    const QByteArray name = QFile::encodeName(path);
    while (true) {
        const int handle =
            open(name.constData(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (handle < 0 && errno == EACCES) {
            const OthersFile outcome = othersFile(name);
            if (outcome == OthersFile::Removed) {
                continue;
            }
            errno = EACCES;
            return {-1, outcome == OthersFile::Held ? LockedFile::Outcome::HeldByAnother
                                                    : LockedFile::Outcome::Failed};
        }
        if (handle < 0) {
            return {};
        }
        if (!isPlainFile(handle)) {
            close(handle);
            errno = EEXIST;
            return {};
        }
        const bool isLocked = flock(handle, LOCK_EX | LOCK_NB) == 0;
        if (!isLocked && errno == EWOULDBLOCK) {
            close(handle);
            return {-1, LockedFile::Outcome::HeldByAnother};
        }
        if (isStillAt(name, handle)) {
            return {handle, LockedFile::Outcome::Opened, isLocked};
        }
        close(handle);
    }
}

#endif

QString systemsWords() {
#ifdef _WIN32
    const std::error_code error(int(GetLastError()), std::system_category());
#else
    const std::error_code error(errno, std::generic_category());
#endif
    return QString::fromStdString(error.message());
}

} // namespace

LockedFile::Outcome LockedFile::open(const QString& path) {
    path_ = path;
    const Handle handle = lockedHandle(path);
    isLocked_ = handle.isLocked;
    if (handle.outcome != Outcome::Opened) {
        failure_ = systemsWords();
        return handle.outcome;
    }
    if (!file_.open(handle.number, QIODevice::ReadWrite, QFileDevice::AutoCloseHandle)) {
        failure_ = file_.errorString();
        return Outcome::Failed;
    }
    return Outcome::Opened;
}

QString LockedFile::errorString() const {
    return failure_.isEmpty() ? file_.errorString() : failure_;
}

bool LockedFile::remove() {
    const bool removed = !isOpen() || QFile::remove(path_);
    file_.close();
    return removed;
}

bool LockedFile::moveOver(const QString& target) {
#ifdef _WIN32
    file_.close(); // Windows cannot rename an open file over another
#endif
    const bool moved = dipwright::moveOver(path_, target);
    if (!moved) {
        failure_ = systemsWords();
    }
    file_.close();
    return moved;
}

bool syncToDisk(QFile& file) {
    if (!file.flush()) {
        return false;
    }
#ifdef _WIN32
    return _commit(file.handle()) == 0;
#else
    return fsync(file.handle()) == 0;
#endif
}

void syncFolder([[maybe_unused]] const QString& path) {
#ifndef _WIN32
    const int handle =
        open(QFile::encodeName(path).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle >= 0) {
        fsync(handle);
        close(handle);
    }
#endif
}

bool moveOver(const QString& from, const QString& to) {
    std::error_code error;
    std::filesystem::rename(QFileInfo(from).filesystemFilePath(),
                            QFileInfo(to).filesystemFilePath(), error);
#ifndef _WIN32
    errno = error.value();
#endif
    return !error;
}

} // namespace dipwright

#include "serving/SocketFile.h"

#include "base/Error.h"

#include <QFile>

#ifdef Q_OS_UNIX
#include <algorithm>
#include <cerrno>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#endif

namespace dipwright {

#ifdef Q_OS_UNIX

namespace {

// Tells whether nothing listens on the socket any more.
bool isAbandoned(const QByteArray& name) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(name.begin(), name.end(), address.sun_path);
    const int probe = socket(AF_UNIX, SOCK_STREAM, 0);
    const bool isRefused =
        probe >= 0 && connect(probe, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0 &&
        errno == ECONNREFUSED;
    if (probe >= 0) {
        close(probe);
    }
    return isRefused;
}

} // namespace

OwnerOnly::OwnerOnly() : before_(umask(0077)) {}

OwnerOnly::~OwnerOnly() {
    umask(mode_t(before_));
}

void clearSocket(const QString& path) {
    constexpr qsizetype longest = sizeof(sockaddr_un::sun_path) - 1;
    const QByteArray name = QFile::encodeName(path);
    if (name.size() > longest) {
        throw Error(
            QStringLiteral("The socket's path is longer than %1 bytes; choose a shorter one")
                .arg(longest),
            path);
    }
    struct stat status {};
    if (lstat(name.constData(), &status) != 0) {
        return; // there is nothing
    }
    if (!S_ISSOCK(status.st_mode)) {
        throw Error(QStringLiteral("There is a file of this name that is no socket; choose another "
                                   "name"),
                    path);
    }
    if (!isAbandoned(name)) {
        throw Error(QStringLiteral("Another program may listen on this socket; end it, or "
                                   "choose another name"),
                    path);
    }
    unlink(name.constData());
}

#else

OwnerOnly::OwnerOnly() = default;
OwnerOnly::~OwnerOnly() = default;

void clearSocket(const QString& path) {
    throw Error(QStringLiteral("This system has no Unix sockets; use a port"), path);
}

#endif

} // namespace dipwright

// The file of a Unix socket.
#pragma once

#include <QString>

namespace dipwright {

// While it lives, the program creates files that only their owner may use. For the whole process.
class OwnerOnly {
public:
    OwnerOnly();
    ~OwnerOnly();
    OwnerOnly(const OwnerOnly&) = delete;
    OwnerOnly& operator=(const OwnerOnly&) = delete;

private:
    unsigned before_ = 0;
};

// Removes a socket that no program listens on any more. Throws Error if the path is too long, is
// something else or is in use, or if the system has no Unix sockets.
void clearSocket(const QString& path);

} // namespace dipwright

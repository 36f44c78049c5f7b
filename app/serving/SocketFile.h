// The file of a Unix socket.
#pragma once

#include <QString>

namespace dipwright {

// While an object lives, all files that this process creates are for their owner only.
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

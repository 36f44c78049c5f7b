// The address of a job server: a Unix socket or a port of the loopback interface.
#pragma once

#include <QString>

namespace dipwright {

struct ServerAddress {
    QString socket; // path of a Unix socket; empty: a port
    QString host = QStringLiteral("127.0.0.1");
    int port = 0;

    bool isSocket() const { return !socket.isEmpty(); }
    QString text() const; // as serverAddress() reads it
};

// Reads "/run/jobs.sock", "8137", "localhost:8137", "127.0.0.1:8137" or "[::1]:8137". Throws Error
// for other hosts than loopback: without TLS, others could read token and projects on the way.
ServerAddress serverAddress(const QString& text);

} // namespace dipwright

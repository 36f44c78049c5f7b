// Serves the jobs of a folder over HTTP: submit, list, progress, cancel, results
// (docs/serve.md; every request: docs/serve-openapi.json).
//
// Listens on a Unix socket that only its owner may use, or on a port of the loopback interface, and
// answers only requests with the token. The connection is not encrypted, so no other address is
// possible (ServerAddress.h).
#pragma once

#include "serving/JobSpool.h"
#include "serving/ServerAddress.h"

#include <memory>

namespace dipwright {

// Throws Error if a project's file cannot be a project.
using CheckUpload = std::function<void(const QString& path)>;

class JobServer {
public:
    // Binds the address and answers on its own threads. `spool` must outlive the server. A socket
    // file that no program uses any more is replaced. Throws Error if the address cannot be used.
    JobServer(const ServerAddress& address, const QByteArray& token, JobSpool& spool,
              CheckUpload check);
    ~JobServer(); // ends all connections and removes the socket

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

// Returns a new random token, 43 letters, digits, - and _.
QByteArray newToken();
// Returns the token in a file, which is created for its owner alone with a new token if it is
// missing. Throws Error if others than the owner may read the file, or it holds no token.
QByteArray tokenIn(const QString& path);

} // namespace dipwright

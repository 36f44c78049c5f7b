// Sends jobs to a job server and fetches their results (JobServer.h).
#pragma once

#include "base/Progress.h"
#include "serving/ServerAddress.h"

#include <QByteArray>
#include <QJsonObject>
#include <functional>
#include <memory>

namespace dipwright {

// Used by one thread at a time. All functions throw Error with the server's own sentence. They also
// throw Error if the server cannot be reached or its answer is too long.
class ServerClient {
public:
    ServerClient(const ServerAddress& address, const QByteArray& token);
    ~ServerClient();

    QJsonObject status();
    // Sends a project's file. Throws Error if the file is too large for the server. Returns the id
    // of the job. Throws Cancelled; no job is then left on the server.
    QString submit(const QString& project, const QString& name, const CancelToken& cancelToken);
    QJsonObject job(const QString& id);
    void cancel(const QString& id);
    void remove(const QString& id);
    // Saves one of the job's files as `path`, at most `mostBytes`. Throws Cancelled.
    void fetch(const QString& id, const QString& name, const QString& path, qint64 mostBytes,
               const CancelToken& cancelToken);

    // Cancels and removes the job as far as the server can be reached. Throws nothing.
    void abandon(const QString& id);

    // Waits until the job has ended, and reports its progress. Returns job(id). Cancels the job and
    // throws Cancelled when cancelled. Waits a minute for a server that does not answer. Throws
    // Error if the job failed or was cancelled by others.
    QJsonObject wait(const QString& id, const Progress& progress);

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright

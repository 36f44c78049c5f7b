// Keeps the jobs of a server in a folder, and runs them one after the other.
//
// Subfolders: queued, running, done, failed and cancelled hold the projects by state (ID.dipw);
// results/ID holds the results; incoming holds uploads. Jobs survive a restart: queued jobs stay
// queued. If the program is stopped, the running job is queued again. If it crashes, that job has
// failed.
#pragma once

#include "base/Progress.h"
#include "serving/StateFolders.h"

#include <QDateTime>
#include <QJsonObject>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace dipwright {

enum class ServedState { Queued, Running, Done, Failed, Cancelled };
QString nameOf(ServedState state); // "queued", …

struct ServedJob {
    QString id;
    QString name; // of the project's file, without .dipw
    ServedState state = ServedState::Queued;
    QDateTime submitted; // UTC
    double progress = 0; // 0 … 1
    QString text;        // what is being done, or why the job failed
    QJsonObject outcome; // from RunServedJob
};

struct SpoolLimits {
    int mostJobs = 100;             // jobs in the folder, finished ones too
    qint64 mostBytes = 500'000'000; // of one project
    int mostSeconds = 3600;         // of one run
};

// Runs the project file and writes its results into `folder`. Returns ServedJob::outcome.
// Throws Error or Cancelled.
using RunServedJob = std::function<QJsonObject(const QString& project, const QString& folder,
                                               const Progress& progress)>;

// Thread-safe.
class JobSpool {
public:
    // Locks the folder, reads its jobs and starts to run them on a thread. Throws Error.
    JobSpool(const QString& folder, const SpoolLimits& limits, RunServedJob run);
    ~JobSpool(); // stops, and waits for the running job
    // Runs no more jobs. The running job is cancelled and queued again; does not wait for it.
    void stop();

    const SpoolLimits& limits() const { return limits_; }
    // Returns the path for a new upload in the folder `incoming`, where no file exists yet. Nothing
    // if there are too many jobs or uploads, or too little room on the disk. Afterwards call add()
    // or dropUpload() with this path.
    std::optional<QString> newUpload();
    void dropUpload(const QString& upload);
    // Queues an uploaded project. `name` may be any text. Throws Error.
    ServedJob add(const QString& upload, const QString& name);

    std::vector<ServedJob> jobs() const; // the oldest first
    std::optional<ServedJob> job(const QString& id) const;
    // Cancels a queued or running job. Returns false if there is none of this id.
    bool cancel(const QString& id);
    // Removes a job and its results. A running job is cancelled, and removed when it ends. Returns
    // false if there is none of this id.
    bool remove(const QString& id);
    // Returns the names of a job's result files, with / between folders, sorted.
    QStringList files(const QString& id) const;
    // Returns the path of one of files(); empty if there is none of this name.
    QString file(const QString& id, const QString& name) const;

private:
    QString projectOf(const ServedJob& job) const;
    QString resultsOf(const QString& id) const;
    void readJobs();
    void work();
    bool begin(const QString& id, const CancelToken& cancelToken);
    void run(const QString& id);
    QJsonObject runWithinTime(const QString& id, const CancelToken& cancelToken);
    void end(const QString& id, ServedState state, const QString& text, const QJsonObject& outcome);
    void erase(const QString& id);
    void record(const ServedJob& job) const;

    StateFolders folders_;
    SpoolLimits limits_;
    RunServedJob run_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::map<QString, ServedJob> jobs_; // by id, which begins with the time
    int uploads_ = 0;
    CancelToken current_;
    QString running_;                                  // id; empty: none
    bool userCancelled_ = false, userRemoved_ = false; // the running job
    bool ending_ = false;
    std::thread worker_;
};

} // namespace dipwright

// Runs jobs one after the other on a worker thread and finalizes them on the UI thread.
#pragma once

#include "workbench/jobs/Job.h"

#include <QObject>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

namespace dipwright {

class JobRunner : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::seconds longestEnd{30};

    explicit JobRunner(QObject* parent = nullptr);
    // Cancels all jobs and waits for the worker thread. Finalizes no more jobs. If a job does not
    // end within `longestEnd`, ends the whole program, because a call that hangs cannot be stopped
    // on its own. Unsaved work of other windows is kept (workbench/document/Recovery.h), and file
    // writes are atomic.
    ~JobRunner() override;

    CancelToken start(std::unique_ptr<Job> job); // the token cancels this job
    void cancelAll();
    bool isBusy() const { return unfinished_ > 0; }

signals:
    void busy(); // the first job was added after an idle time
    void started(const QString& title);
    void progressed(double share, const QString& text); // 0 … 1
    void idle();                                        // all jobs have been finalized

private:
    struct Entry {
        std::shared_ptr<Job> job;
        CancelToken cancelToken;
    };
    void work();
    void run(const Entry& entry);
    void report(double share, const QString& text);
    void deliverReport();

    std::mutex mutex_;
    std::condition_variable wake_, gone_;
    std::deque<Entry> waiting_;
    CancelToken current_;
    bool ending_ = false;
    bool ended_ = false;
    bool reportPending_ = false;
    double share_ = 0;
    QString text_;
    int unfinished_ = 0; // UI thread only
    std::thread worker_;
};

} // namespace dipwright

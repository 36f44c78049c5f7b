// Runs jobs one after the other on one worker thread and brings their ends back to the UI thread.
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
    // Cancels everything and waits for the worker; nothing is finalized any more. Work that does
    // not end within `longestEnd` takes the program with it: a call that hangs cannot be ended
    // alone. What other windows have not saved is kept (workbench/document/Recovery.h), and files
    // are written whole or not at all.
    ~JobRunner() override;

    CancelToken start(std::unique_ptr<Job> job); // which cancels this one
    void cancelAll();
    bool isBusy() const { return unfinished_ > 0; }

signals:
    void busy(); // something has been given to do, after nothing
    void started(const QString& title);
    void progressed(double share, const QString& text); // 0 … 1
    void idle();                                        // everything has been finalized

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

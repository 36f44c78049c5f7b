// Projects that are run one after the other, as they are saved, while their user goes on working:
// each into a folder of its own, and one that fails leaves the others alone. UI thread only.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/jobs/JobRunner.h"

#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

namespace dipwright {

enum class QueuedState { Waiting, Running, Done, Failed, Cancelled };

struct QueuedProject {
    QString project, folder; // its file, and where its results go
    QueuedState state = QueuedState::Waiting;
    double share = 0;   // 0 … 1, of the one that runs
    QString text = {};  // what it is at; then what came of it, or a sentence why it failed
    double seconds = 0; // it took; 0: it has not ended
};

class JobQueue : public QObject {
    Q_OBJECT

public:
    explicit JobQueue(const SolverRegistry& registry, QObject* parent = nullptr);

    // Behind those that wait. `folder`: in it each has its own (resultFolders()).
    void add(const QStringList& projects, const QString& folder);
    void cancel(std::size_t number); // nothing where it has ended
    void cancelAll();
    void removeEnded();
    // Whether the dips are kept beside the projects, for who opens them (pipeline/DipCache.h).
    void setKeepsDips(bool keeps) { keepsDips_ = keeps; }

    const std::vector<QueuedProject>& projects() const { return projects_; }
    bool isBusy() const { return jobs_.isBusy(); }
    // Until all are done, from how long those before took; nothing while that is not known.
    std::optional<double> secondsLeft() const;

signals:
    void changed();                      // of projects(), however little
    void ended(const QString& sentence); // nothing waits any more: what has come of them

private:
    struct Entry {
        int key = 0; // rows go, keys stay
        CancelToken cancelToken;
        std::chrono::steady_clock::time_point begun;
    };
    void start(const QueuedProject& project, Entry& entry);
    void begin(int key);
    void report(double share, const QString& text);
    void end(int key, QueuedState state, const QString& text);
    void tellEnd();
    std::size_t rowOf(int key) const;

    const SolverRegistry& registry_;
    std::vector<QueuedProject> projects_;
    std::vector<Entry> entries_; // of each project
    int lastKey_ = 0, runningKey_ = 0;
    bool keepsDips_ = false;
    JobRunner jobs_; // ends before what it reports to
};

} // namespace dipwright

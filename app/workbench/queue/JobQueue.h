// Runs projects one after the other in the background. Uses the saved version of each project and
// writes its results to its own folder. A failed project does not affect the others. UI thread
// only.
#pragma once

#include "solver/SolverRegistry.h"
#include "traveller/TankTasks.h"
#include "workbench/jobs/JobRunner.h"

#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

namespace dipwright {

enum class QueuedState { Waiting, Running, Done, Failed, Cancelled };

struct QueuedProject {
    QString project, folder; // the project file, and the folder for its results
    QueuedState state = QueuedState::Waiting;
    double share = 0;                 // progress of the run, 0 … 1
    QString text = {};                // progress; later the result, or the reason of a failure
    double seconds = 0;               // run time; 0: not ended yet
    std::optional<TankJob> tank = {}; // the steps at the tank; none: not done
};

class JobQueue : public QObject {
    Q_OBJECT

public:
    explicit JobQueue(const SolverRegistry& registry, QObject* parent = nullptr);

    // Adds projects at the end of the queue. Each gets its own folder in `folder`
    // (resultFolders()).
    void add(const QStringList& projects, const QString& folder);
    void cancel(std::size_t number); // no effect if the project has ended
    void cancelAll();
    void removeEnded();
    // Whether dips are cached beside the projects, to be reused when a project is opened
    // (pipeline/DipCache.h).
    void setKeepsDips(bool keeps) { keepsDips_ = keeps; }

    const std::vector<QueuedProject>& projects() const { return projects_; }
    bool isBusy() const { return jobs_.isBusy(); }
    // Estimated time until all are done, from the run times so far. nullopt while it is unknown.
    std::optional<double> secondsLeft() const;

signals:
    void changed();                      // any change of projects()
    void ended(const QString& sentence); // the queue is empty; a summary

private:
    struct Entry {
        int key = 0; // stays the same when rows are removed
        CancelToken cancelToken;
        std::chrono::steady_clock::time_point begun;
    };
    void start(const QueuedProject& project, Entry& entry);
    void begin(int key);
    void report(double share, const QString& text);
    void end(int key, QueuedState state, const QString& text, std::optional<TankJob> tank);
    void tellEnd();
    std::size_t rowOf(int key) const;

    const SolverRegistry& registry_;
    std::vector<QueuedProject> projects_;
    std::vector<Entry> entries_; // one for each project
    int lastKey_ = 0, runningKey_ = 0;
    bool keepsDips_ = false;
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright

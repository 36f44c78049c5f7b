// Runs the pose search of a window as a job, updates its page and applies poses.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/dip/DipSession.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"
#include "workbench/poses/SearchPage.h"

#include <QPointer>

namespace dipwright {

class SearchController : public QObject {
    Q_OBJECT

public:
    SearchController(const DipSession& session, JobRunner& jobs, const SolverRegistry& registry,
                     Messages& messages, QObject* parent);

    QWidget* page() const; // owned by the window that shows it
    // Call this when the session has another document.
    void showDocument();

signals:
    void comparisonAsked(const std::array<dipwright::ComparedState, 2>& states);

private:
    struct Update;
    class Watcher;
    void start();
    void end();
    void take(const Update& update);
    void apply(const std::vector<Immersion>& immersions);
    void applySide(const Eigen::Vector3d& down);
    void takeAims(const QString& what);
    void showProject();
    void showFreshness();

    const DipSession& session_;
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    SearchPage* page_;
    std::shared_ptr<Watcher> watcher_; // of the running search; null: none
    CancelToken running_;
    Project searched_; // the project at the time of the search
};

} // namespace dipwright

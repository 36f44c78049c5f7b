// The pose search of a window: runs it as a job, keeps its page up to date, takes poses over.
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

    QWidget* page() const; // belongs to who puts it into a window
    // To be called when the session has another document.
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
    std::shared_ptr<Watcher> watcher_; // of the search that runs; null: none does
    CancelToken running_;
    Project searched_; // as it was when it was searched for
};

} // namespace dipwright

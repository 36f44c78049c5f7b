// Runs the pose search of a window on a thread of its own, beside the window's dips; updates its
// page and applies poses.
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
    SearchController(DipSession& session, const SolverRegistry& registry, Messages& messages,
                     QObject* parent);

    QWidget* page() const; // owned by the window that shows it
    // Call this when the session has another document.
    void showDocument();

signals:
    void poseTried();     // the user wants to see a pose, which has been set
    void triedPoseUsed(); // the film of the pose that was tried is worth refining now
    void comparisonAsked(const std::array<dipwright::ComparedState, 2>& states);

private:
    struct Update;
    class Watcher;
    void start();
    void end();
    void yieldToDip();
    void take(const Update& update);
    void apply(const RankedPoses& poses);
    void keepDips(const RankedPoses& poses);
    void applySide(const Eigen::Vector3d& down);
    void takeAims(const QString& what);
    void showProject();
    void showFreshness();

    DipSession& session_;
    const SolverRegistry& registry_;
    Messages& messages_;
    SearchPage* page_;
    std::shared_ptr<Watcher> watcher_; // of the running search; null: none
    CancelToken running_;
    Project searched_;          // the project at the time of the search
    SolverInfo searchedSolver_; // of the last search that ended; its id is empty if there is none
    JobRunner jobs_;            // destroyed first: its thread uses the members above
};

} // namespace dipwright
